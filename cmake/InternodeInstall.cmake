# SPDX-License-Identifier: MIT
# The installed package: find_package(internode) gives internode::internode, and brings its own FindEAntic.cmake.
include(CMakePackageConfigHelpers)

set(internode_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/internode)

install(TARGETS internode EXPORT internode
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT internode NAMESPACE internode:: FILE internodeTargets.cmake DESTINATION ${internode_PACKAGE_DIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/internodeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/internodeConfig.cmake INSTALL_DESTINATION ${internode_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/internodeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/internodeConfig.cmake ${PROJECT_BINARY_DIR}/cmake/internodeConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindEAntic.cmake
        DESTINATION ${internode_PACKAGE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The command: cli/ names its target internode_cli, the file it makes `internode`.
if(TARGET internode_cli)
  install(TARGETS internode_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
