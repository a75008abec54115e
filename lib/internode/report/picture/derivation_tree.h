// SPDX-License-Identifier: MIT
//
// The derivation tree of a few steps, as S1 draws it in figure 5: a row per word, the axiom on top. Modules with
// parameters are circles, modules without are horizontal lines (edges). Solid arrows lead from the strict predecessor
// to its successor, dashed ones from the contexts whose parameters were read.
//
// Successors stand below their predecessor: a module is as wide as what becomes of it. In a ring, contexts across the
// seam come in from the side. Colours tell letters apart, and states: the first number beside a point.

#pragma once

#include "internode/point/interpreter.h"
#include "internode/report/generator.h"

#include <cstddef>
#include <string>
#include <vector>

namespace internode {

/// Modules that a tree may have, and those of its widest row.
inline constexpr std::size_t max_tree_modules = 4'000;
inline constexpr std::size_t max_tree_row = 400;

struct DerivationTree {
    std::vector<ModuleWord> words{};      ///< the axiom first, at least one
    std::vector<StepRecord> steps{};      ///< how each word became the next: one less than words
    std::vector<std::string> row_names{}; ///< a name for each word; plain text
    std::string title{};
    Generator generator{};
};

/// Whether a tree of these words can be drawn.
[[nodiscard]] bool fits_in_tree(const std::vector<ModuleWord>& words);

/// An SVG text. \throw std::invalid_argument for words that do not fit, and for numbers of rows that do not agree
[[nodiscard]] std::string derivation_tree(const DerivationTree& tree, const PointSystem& system);

} // namespace internode
