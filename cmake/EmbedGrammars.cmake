# SPDX-License-Identifier: MIT
#
# cmake -DOUTPUT=file.cpp -DFOLDER=data/grammars "-DINTERVALS=a;b" "-DPOINTS=s0/13" -P EmbedGrammars.cmake
# writes internode::bundled_grammars() with the texts FOLDER/NAME.lsys as raw string literals, in the order of their
# names.

cmake_minimum_required(VERSION 3.25)

# A raw string literal ends at the first `)delimiter"`: a delimiter that the text does not contain.
function(find_delimiter text result)
  set(delimiter lsys)
  set(number 0)
  while(TRUE)
    string(FIND "${text}" ")${delimiter}\"" place)
    if(place EQUAL -1)
      break()
    endif()
    math(EXPR number "${number} + 1")
    set(delimiter lsys${number})
  endwhile()
  set(${result} ${delimiter} PARENT_SCOPE)
endfunction()

set(names ${INTERVALS} ${POINTS})
list(SORT names)
list(LENGTH names count)
set(entries "")
foreach(name IN LISTS names)
  set(kind Intervals)
  if(name IN_LIST POINTS)
    set(kind Points)
  endif()
  file(READ ${FOLDER}/${name}.lsys text)
  find_delimiter("${text}" delimiter)
  string(APPEND entries "    {\"${name}\", R\"${delimiter}(${text})${delimiter}\", GrammarKind::${kind}},\n")
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
