// SPDX-License-Identifier: MIT
//
// The tables of an automaton as initialisers that C, C++ and GLSL share. Not installed.

#pragma once

#include "internode/report/code/automaton_code.h"
#include "internode/report/point_masks.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct CodeTables {
    std::string name;                   ///< fibonacci_3
    std::size_t degree = 0;             ///< rows have degree + 1 weights
    std::vector<std::uint32_t> lead;    ///< z of each state: its first parent is cell + z - degree
    std::vector<std::uint32_t> first;   ///< first child of each state, and the number of children
    std::vector<std::uint32_t> child;   ///< state of each child
    std::vector<std::uint32_t> row;     ///< row of each child
    std::vector<std::uint32_t> windows; ///< 2d - 1 symbols of each state: 0 the empty interval, else 1 + its index
};

[[nodiscard]] CodeTables code_tables(const AutomatonExport& exported);

/// Of a point grammar; without windows. Rows get zeros at their ends so that no z is negative.
[[nodiscard]] CodeTables code_tables(const CellExport& exported);

/// "{\n    1u, 2u,\n    …}": `per_line` values a line, each with `suffix`.
[[nodiscard]] std::string initializer(const std::vector<std::uint32_t>& values, std::size_t per_line,
                                      std::string_view suffix);

/// The weights row by row, `width` in each, with a point or an exponent, and `suffix`. `nested`: rows in braces of
/// their own.
[[nodiscard]] std::string weight_initializer(const CellAutomaton& automaton, std::size_t width, bool nested,
                                             std::string_view suffix);

/// What the file is, as lines of a block comment that is still open.
[[nodiscard]] std::string opening_comment(const AutomatonExport& exported, const Generator& generator);
[[nodiscard]] std::string opening_comment(const CellExport& exported);

/// Every `@` of a text becomes `name`.
[[nodiscard]] std::string with_name(std::string_view text, std::string_view name);

} // namespace internode
