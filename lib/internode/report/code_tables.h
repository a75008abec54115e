// SPDX-License-Identifier: MIT
//
// The tables of an automaton as initialisers that C, C++ and GLSL share. Not installed.

#pragma once

#include "internode/report/automaton_code.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct CodeTables {
    std::string name;                   ///< fibonacci_3
    std::vector<std::uint32_t> lead;    ///< z of each state
    std::vector<std::uint32_t> first;   ///< first child of each state, and the number of children
    std::vector<std::uint32_t> child;   ///< state of each child
    std::vector<std::uint32_t> row;     ///< row of each child
    std::vector<std::uint32_t> windows; ///< 2d - 1 symbols of each state: 0 the empty interval, else 1 + its index
};

[[nodiscard]] CodeTables code_tables(const AutomatonExport& exported);

/// "{\n    1u, 2u,\n    …}": `per_line` values a line, each with `suffix`.
[[nodiscard]] std::string initializer(const std::vector<std::uint32_t>& values, std::size_t per_line,
                                      std::string_view suffix);

/// The weights row by row, each with a point or an exponent, and `suffix`. `nested`: rows in braces of their own.
[[nodiscard]] std::string weight_initializer(const StencilAutomaton& automaton, bool nested, std::string_view suffix);

/// What the file is, as lines of a block comment that is still open.
[[nodiscard]] std::string opening_comment(const AutomatonExport& exported, const Generator& generator);

/// Every `@` of a text becomes `name`.
[[nodiscard]] std::string with_name(std::string_view text, std::string_view name);

} // namespace internode
