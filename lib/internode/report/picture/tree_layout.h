// SPDX-License-Identifier: MIT
//
// Where the modules of a derivation stand in the picture of its tree: in units across, every row by itself.
//
// A strict predecessor and its successors are a family. A family is as wide as the wider of the two rows; the widths
// are added up from the last word to the axiom, the places handed down again.

#pragma once

#include "internode/point/interpreter.h"

#include <cstddef>
#include <span>
#include <vector>

namespace internode {

struct TreeLayout {
    std::vector<std::vector<double>> centre; ///< the middle of each module of each word
    double width = 0;                        ///< the width of the whole tree
};

/// `strict[r][i]`: how many modules of word r the rule took that gave module i of word r + 1, from its parent on.
using StrictSizes = std::vector<std::vector<std::size_t>>;

[[nodiscard]] StrictSizes strict_sizes(std::span<const StepRecord> steps, const PointGrammar& grammar);

/// `sizes` are those of the words, one more than there are steps.
[[nodiscard]] TreeLayout tree_layout(std::span<const std::size_t> sizes, std::span<const StepRecord> steps,
                                     const StrictSizes& strict);

} // namespace internode
