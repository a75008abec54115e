// SPDX-License-Identifier: MIT
//
// A pyramid as a file gives it: JSON of format "internode-pyramid" (docs/json.md), which holds grammar, lengths, coarse
// polygon and details, and so all that a synthesis needs.
//
// Reading and believing are two stages: read_pyramid() has a place for whatever is no pyramid; checked_pyramid()
// proves the grammar valid again and holds sizes against its words.

#pragma once

#include "internode/curve/reverse/pyramid.h"
#include "internode/io/polygon.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct InputWord {
    std::vector<std::string> letters;
    bool closed = false;
};

struct InputRule {
    std::string symbol;
    std::vector<std::string> word;
};

struct InputPyramid {
    std::size_t degree = 0;
    std::string name;               ///< of the grammar
    std::vector<InputRule> rules;   ///< in the order of the file
    std::optional<InputWord> axiom; ///< of the grammar
    std::vector<InputLength> lengths;
    ReverseOptions options;
    InputWord word;             ///< of the coarse polygon
    std::size_t dimension = 0;  ///< 1 … max_dimension
    std::vector<double> points; ///< of the coarse polygon, at least one row
    std::vector<PyramidLevel> levels;
};

struct ParsedPyramid {
    std::optional<InputPyramid> pyramid; ///< present iff errors is empty
    std::vector<Diagnostic> errors;      ///< the first faults, in the order of the text
};

/// Never throws on any text (but std::bad_alloc). Cost: linear in the text.
[[nodiscard]] ParsedPyramid read_pyramid(std::string_view text, std::string_view source);

/// Whether it all fits. Cost: that of validate(), and linear in the details.
[[nodiscard]] CheckedPyramid checked_pyramid(const InputPyramid& input);

} // namespace internode
