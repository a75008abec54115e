// SPDX-License-Identifier: MIT
//
// Which numbers of points a polygon can have to be taken apart: N = |σ^n(w)| closed, N = |σ^n(domain)| + d open.
//
// The hierarchy is fixed from its coarse end: the word w and the number n of levels. Either w is given and n may vary,
// or n is given and w is as many letters of a repeated pattern as needed. Not every N is possible.

#pragma once

#include "internode/word/morphism.h"

#include <cstdint>
#include <optional>

namespace internode {

enum class PolygonEnds { Open, Closed, Clamped };

struct CoarseWord {
    Word letters;        ///< the word of the coarse polygon (of its domain when clamped), or a pattern for it
    bool repeat = false; ///< whether the letters repeat as often as needed
    PolygonEnds ends = PolygonEnds::Open;
    int degree = 1;
};

struct PossibleSize {
    std::uint64_t points = 0; ///< points of the fine polygon
    int levels = 0;
    Word word; ///< word of the coarse polygon, clamped ends included
};

/// Both the same when the number of points is possible.
struct PossibleSizes {
    std::optional<PossibleSize> below; ///< the largest that is not above the number asked for
    std::optional<PossibleSize> above; ///< the smallest that is not below it
    [[nodiscard]] bool exact() const { return below && above && below->points == above->points; }
};

/// Without `levels`, the fewest that give a number of points. Every letter must grow, as it does in a valid system.
/// Cost: linear in the points, and in the levels. \throw std::invalid_argument for a pattern without levels, an empty
/// word, a negative number of levels
[[nodiscard]] PossibleSizes possible_sizes(const Morphism& rules, const CoarseWord& coarse, std::optional<int> levels,
                                           std::uint64_t points);

} // namespace internode
