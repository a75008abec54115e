// SPDX-License-Identifier: MIT
//
// Everything `internode masks` says about a system and a degree: the decomposition graph with the mask of each word
// (d+1 letters), and the windows (2d-1 letters) with their stencils, closed under children.
//
// Windows start from the same choice of words as the decompositions. Of an axiom, from the windows of its cells (of
// its domain when it is open), so that the table refines exactly the curves that the axiom describes.

#pragma once

#include "internode/interval/decomposition_graph.h"
#include "internode/spline/exact_work.h"
#include "internode/spline/mask.h"
#include "internode/spline/window.h"

#include <cstdint>
#include <vector>

namespace internode {

struct WindowRow {
    WindowStencils stencils;
    std::vector<std::uint32_t> children; ///< index in windows of each child window
    bool persistent = false;             ///< the window lies on a cycle of windows, or is reached from one
};

struct MaskTable {
    IntervalSystem system;
    int degree = 1;
    WordChoice choice = WordChoice::Persistent; ///< the choice that was made: never Default
    FactorGraph graph;                          ///< the decomposition graph of words of d+1 letters
    std::vector<Mask> masks;                    ///< the mask of each word of the graph
    std::vector<WindowRow> windows;             ///< breadth first from the start
    bool has_leading = false;                   ///< some cell of the axiom leads its interval: open or with `0`
};

/// degree 1 … 12. \throw TooManyWords beyond so many words or windows and TooMuchWork beyond so much work, before any
/// weight is derived; std::invalid_argument for Reachable without an axiom and for an axiom that does not fit the
/// degree
[[nodiscard]] MaskTable make_mask_table(const IntervalSystem& system, int degree, WordChoice choice,
                                        const ExactLimits& limits);

} // namespace internode
