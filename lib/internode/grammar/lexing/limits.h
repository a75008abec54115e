// SPDX-License-Identifier: MIT
//
// What a grammar or a word may be at most. Reading is linear in the text and in the letters that its powers stand
// for; these numbers keep both small enough to be read in about a second. A refusal names its number.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/text/limits.h"

#include <array>
#include <cstddef>

namespace internode {

inline constexpr std::size_t max_grammar_bytes = std::size_t{16} << 20;
inline constexpr std::size_t max_line_bytes = std::size_t{12} << 20; ///< a word has no line breaks: it must fit
inline constexpr std::size_t max_symbols = 100'000;
inline constexpr std::size_t max_rule_letters = 1'000'000;
inline constexpr std::size_t max_word_letters = 10'000'000;
inline constexpr std::size_t max_name_bytes = 100;
inline constexpr std::size_t max_kept_errors = 1'000;

// Of point grammars. What powers and functions make of a text is bounded as well: a grammar in memory is at most some
// hundred bytes a module and a few dozen an instruction.
inline constexpr std::size_t max_nesting = 200;
inline constexpr std::size_t max_parameters = 64;
inline constexpr std::size_t max_coordinates = 64;
inline constexpr std::size_t max_point_letters = 1'000;
inline constexpr std::size_t max_definitions = 10'000;
inline constexpr std::size_t max_tables = 1'000;
inline constexpr std::size_t max_cycle_items = 10'000;
inline constexpr std::size_t max_predecessor_modules = 1'000; ///< steps of a match, at every module of a word
inline constexpr std::size_t max_point_modules = 100'000;
inline constexpr std::size_t max_expression_instructions = 100'000;
inline constexpr std::size_t max_point_instructions = 1'000'000;
inline constexpr std::size_t max_repeated_instructions = 100'000; ///< `P(v + w)^1000` repeats 3 operations 999 times

/// As `internode limits` prints them.
inline constexpr std::array<Limit, 21> grammar_limits{{
    {"grammar text", max_grammar_bytes, "bytes"},
    {"line of a grammar", max_line_bytes, "bytes"},
    {"symbols of a grammar", max_symbols, "symbols"},
    {"letters of a rule, powers written out", max_rule_letters, "letters"},
    {"letters of a word, and of all words of a grammar, powers written out", max_word_letters, "letters"},
    {"name of a symbol or a grammar", max_name_bytes, "bytes"},
    {"digits of a number", max_digits, "digits"},
    {"decimal exponent of a number, either sign", max_exponent, "decimal places"},
    {"errors kept of one text", max_kept_errors, "errors"},
    {"nesting of an expression", max_nesting, "levels"},
    {"parameters of a module or a function", max_parameters, "parameters"},
    {"coordinates of a point in a grammar", max_coordinates, "numbers"},
    {"letters of a point grammar", max_point_letters, "letters"},
    {"constants and functions of a grammar", max_definitions, "names"},
    {"tables of a grammar", max_tables, "tables"},
    {"tables in a cycle", max_cycle_items, "items"},
    {"modules before an arrow, contexts included", max_predecessor_modules, "modules"},
    {"modules of a point grammar, powers written out", max_point_modules, "modules"},
    {"operations of an expression", max_expression_instructions, "operations"},
    {"operations of a point grammar", max_point_instructions, "operations"},
    {"operations that powers repeat in a point grammar", max_repeated_instructions, "operations"},
}};

} // namespace internode
