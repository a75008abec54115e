# SPDX-License-Identifier: MIT
#
# cmake -DOUTPUT=file.cpp "-DGRAMMARS=a.lsys;b.lsys" -P EmbedGrammars.cmake
# writes internode::bundled_grammars() with the texts of the grammars as raw string literals.

set(entries "")
set(count 0)
foreach(file IN LISTS GRAMMARS)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"lsys(${text})lsys\"},\n")
  math(EXPR count "${count} + 1")
endforeach()

file(WRITE ${OUTPUT} "// SPDX-License-Identifier: MIT
// Written by cmake/EmbedGrammars.cmake from data/grammars.

#include \"internode/grammar/bundled.h\"

#include <array>

namespace internode {

namespace {

constexpr std::array<BundledGrammar, ${count}> grammars{{
${entries}}};

} // namespace

std::span<const BundledGrammar> bundled_grammars() {
    return grammars;
}

} // namespace internode
")
