// SPDX-License-Identifier: MIT
//
// Lengths and frequencies between certified bounds, for valid systems with one final class that are too large for
// exact numbers. With several final classes, or where the iterations do not come close enough, there are none.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/interval/class_graph.h"
#include "internode/interval/quantity.h"

#include <string>
#include <vector>

namespace internode {

/// A declared length that the bounds refute, or cannot confirm.
struct EnclosedConflict {
    Symbol symbol{};
    bool certain = false;
    std::string message;
};

struct EnclosedLengths {
    std::vector<Quantity> lengths; ///< n, or empty
    std::vector<EnclosedConflict> conflicts;
};

/// The shortest symbol has length 1, or the first declared one its own. A symbol that cannot occur has exactly 0.
[[nodiscard]] EnclosedLengths enclosed_lengths(const ClassGraph& graph, const IntervalGrammar& grammar);

/// The left vector, Σ = 1: n quantities, or none.
[[nodiscard]] std::vector<Quantity> enclosed_frequencies(const ClassGraph& graph);

} // namespace internode
