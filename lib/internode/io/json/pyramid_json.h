// SPDX-License-Identifier: MIT
//
// A pyramid as a file gives it: JSON of format "internode-pyramid" (docs/json.md), which holds grammar, lengths, coarse
// polygon and details, and so all that a synthesis needs.
//
// Reading and believing are two stages: read_pyramid() has a place for whatever is no pyramid; settle_pyramid()
// (input/settled_pyramid.h) proves the grammar valid again and holds sizes against its words.

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
    std::string source; ///< the file's name, for diagnostics about what stands here
    std::size_t degree = 0;
    std::string name;               ///< the name of the grammar
    std::vector<InputRule> rules;   ///< the rules of the grammar, in the order of the file
    std::optional<InputWord> axiom; ///< the axiom of the grammar
    std::vector<InputLength> lengths;
    ReverseOptions options;
    InputWord word;                    ///< the word of the coarse polygon
    std::optional<InputNumber> origin; ///< where its parameter begins; none in older files
    std::size_t dimension = 0;         ///< 1 … max_dimension
    std::vector<double> points;        ///< the points of the coarse polygon, at least one row
    std::vector<PyramidLevel> levels;
};

struct ParsedPyramid {
    std::optional<InputPyramid> pyramid; ///< present iff errors is empty
    std::vector<Diagnostic> errors;      ///< the first faults, in the order of the text
};

/// Never throws on any text (but std::bad_alloc). Cost: linear in the text.
[[nodiscard]] ParsedPyramid read_pyramid(std::string_view text, std::string_view source);

} // namespace internode
