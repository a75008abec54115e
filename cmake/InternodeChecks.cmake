# SPDX-License-Identifier: MIT
# Targets that check the text and not the program; CMakePresets.json gives each a build preset, .ci/run calls them.
find_program(INTERNODE_RUN_CLANG_TIDY run-clang-tidy)

# Every source of lib/ and cli/ under .clang-tidy, alone or in its room's unity source, as the clang configuration
# builds it.
if(INTERNODE_RUN_CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
  add_custom_target(tidy
    COMMAND ${INTERNODE_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR} "^(${PROJECT_SOURCE_DIR}/(lib|cli)/|${PROJECT_BINARY_DIR}/.*/Unity/).*"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM)
endif()
