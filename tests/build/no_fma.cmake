# SPDX-License-Identifier: MIT
# Fails when LIBRARY holds a fused multiply-add: one would change the bytes of every curve (docs/promises.md, P10).
execute_process(COMMAND ${OBJDUMP} --disassemble --no-show-raw-insn ${LIBRARY}
                OUTPUT_VARIABLE instructions COMMAND_ERROR_IS_FATAL ANY)
if(NOT instructions MATCHES "mulsd")
  message(FATAL_ERROR "${LIBRARY}: no multiplication found, so the disassembly cannot be trusted")
endif()
if(instructions MATCHES "(vfn?m(add|sub)[0-9a-z]*)")
  message(FATAL_ERROR "${LIBRARY} contains ${CMAKE_MATCH_1}")
endif()
