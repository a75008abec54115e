# SPDX-License-Identifier: MIT
# The library keeps out of its host's affairs: no signals, locale, environment, exit, no printing.
execute_process(COMMAND ${NM} --undefined-only ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "nm cannot read ${LIBRARY}")
endif()
set(surprises "(signal|sigaction|setlocale|getenv|secure_getenv|setenv|putenv|exit|_exit|quick_exit|atexit|printf|puts|putchar|_ZSt4cout|_ZSt4cerr|_ZSt4clog)")
string(REGEX MATCHALL " U ${surprises}\n" found "${symbols}")
if(found)
  message(FATAL_ERROR "the library uses ${found}")
endif()
if(NOT symbols MATCHES " U _ZSt|_Znwm")
  message(FATAL_ERROR "nm showed no symbols at all: this test would prove nothing")
endif()
