# SPDX-License-Identifier: MIT
# Fails when BINARY holds the name of FOLDER, the sources it was built from.
execute_process(COMMAND grep --text --fixed-strings --count -e "${FOLDER}/" ${BINARY}
                OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT lines STREQUAL "0")
  message(FATAL_ERROR "${BINARY} names ${FOLDER} (${lines})")
endif()
