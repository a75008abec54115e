// SPDX-License-Identifier: MIT
//
// Lengths a > 0 with ρ a = M a of a system whose final classes are exactly its basic ones, and the free scales.
//
// a is unique up to one positive scale per final class F. On F it is the Perron vector of the block, and over the other
// symbols N it is a_N = (ρI − M_NN)^{-1} M_NF a_F, class by class. A symbol's *home* is the final class it leads to; a
// symbol that leads to several has for its length a combination with positive weights of their scales.

#pragma once

#include "internode/interval/class_graph.h"
#include "internode/interval/interval_system.h"

#include <vector>

namespace internode {

/// The graph and ratio of a valid system; `ratio` generates `field` unless every class is final.
struct ExactSystem {
    const ClassGraph& graph;
    const NumberField& field;
};

/// Lengths with the shortest symbol of each home equal to 1; 0 for symbols that cannot occur.
[[nodiscard]] std::vector<Number> unit_lengths(const ExactSystem& system);

struct ScaledLengths {
    std::vector<Number> lengths;
    std::vector<LengthConflict> conflicts; ///< empty when every declaration holds exactly
};

/// The lengths scaled per final class so that the declared ones hold; classes without a declaration keep their scale.
/// Declarations of symbols that cannot occur say nothing. One of a symbol that leads to several final classes counts
/// after the others, and only if it leaves one scale open.
/// `names` and `generator` serve the messages. \throw std::invalid_argument for a length that is not positive or not in
/// K
[[nodiscard]] ScaledLengths scale_lengths(const ExactSystem& system, std::vector<Number> lengths,
                                          const std::vector<FixedLength>& declarations, const Alphabet& names,
                                          const std::string& generator);

/// The frequencies s: ρ s = Mᵀ s, Σ s = 1, s = 0 outside the final classes. With one final class they do not depend on
/// the axiom. With several, class F has the share n_0·h_F of the axiom's counts n_0 (h_F the right eigenvector that
/// belongs to F alone, s_F·h_F = 1), and without an axiom the result is empty.
[[nodiscard]] std::vector<Number> frequencies(const ExactSystem& system, const std::optional<Axiom>& axiom);

} // namespace internode
