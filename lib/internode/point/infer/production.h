// SPDX-License-Identifier: MIT
//
// A production whose new points are fixed combinations of the old ones, with numbers for formals:
//
//     P(vl) < P(v) > P(vr) -> P(1/4 vl + 3/4 v) P(3/4 v + 1/4 vr)
//
// is left 1, strict 1, right 1 and two stencils, {(-1, 1/4), (0, 3/4)} and {(0, 3/4), (1, 1/4)}. What inference from a
// matrix and the derivation of reverse rules have in common (Prusinkiewicz et al. 2003, sections 5 to 7).

#pragma once

#include "internode/algebra/rational.h"
#include "internode/grammar/points/point_grammar.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace internode {

struct StencilTerm {
    std::ptrdiff_t offset = 0; ///< how far the old point lies right of the strict predecessor's first module
    Rational weight;           ///< not zero
    friend bool operator==(const StencilTerm&, const StencilTerm&) = default;
};

/// One new point; by ascending offset.
using PointStencil = std::vector<StencilTerm>;

struct PointProduction {
    std::size_t left = 0;   ///< modules P of the left context
    std::size_t strict = 1; ///< modules P of the strict predecessor, at least 1
    std::size_t right = 0;
    bool after_marker = false;  ///< `#` stands before the left context
    bool before_marker = false; ///< `#` stands after the right context
    std::vector<PointStencil> successor;
    friend bool operator==(const PointProduction&, const PointProduction&) = default;
};

/// The contexts that the successor needs, and no more.
[[nodiscard]] PointProduction with_shortest_contexts(std::size_t strict, std::vector<PointStencil> successor);

/// Whether it rewrites one point into itself.
[[nodiscard]] bool is_identity(const PointProduction& production);

enum class WordEnds {
    Ring,        ///< `ring`
    Markers,     ///< `input # P(v) #`
    KeptMarkers, ///< the same, and the rule `# -> #` that S0 eq. 33 writes
};

/// The grammar of the productions in their order, all about one letter `P`. \throw std::invalid_argument for an offset
/// outside the production, markers in a ring
[[nodiscard]] PointGrammar to_grammar(std::string name, WordEnds ends, std::span<const PointProduction> productions);

} // namespace internode
