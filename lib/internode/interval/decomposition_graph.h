// SPDX-License-Identifier: MIT
//
// The decomposition graph of a valid system (Nivoliers et al. 2012, 2.2.2). It has a vertex per word of d + 1 intervals
// under a basis function of degree d, an arc w -> w' for each factor w' of σ(w) in the mask of w.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/word/factors.h"

namespace internode {

/// Which words of m letters a table is about.
enum class WordChoice {
    Default,    ///< Reachable with an axiom, Persistent without
    Reachable,  ///< every word that occurs after some steps from the axiom, step 0 included
    Persistent, ///< the words that occur after arbitrarily many steps, over all axioms
    All,        ///< all n^m
};

/// The graph of words of m letters (m = d + 1 for decompositions, 2d - 1 for windows).
/// \throw TooManyWords beyond `limit`, std::invalid_argument for Reachable without an axiom or m = 0
[[nodiscard]] FactorGraph word_graph(const IntervalSystem& system, std::size_t m, WordChoice choice, std::size_t limit);

} // namespace internode
