# SPDX-License-Identifier: MIT
# cmake -D PROGRAM=… -D EXPECTED=FILE -P compare.cmake: the program succeeds and prints what stands in the file.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${status}:\n${printed}")
endif()
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${PROGRAM} prints\n${printed}and not\n${expected}")
endif()
