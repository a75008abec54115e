// SPDX-License-Identifier: MIT
//
// Refined knots seen from the given ones: a step replaces a letter by letters whose lengths add up to its own. So the
// non-empty intervals of a refined domain follow those of the given one, as many from each as it has descendants.

#pragma once

#include "internode/curve/spans.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace internode {

/// Where a refined knot lies: behind the begin of a letter of the given word, in units of Spans.
struct KnotPlace {
    std::size_t letter = 0;
    DoubleDouble offset;
};

/// Walks through the non-empty intervals of a refined domain, and knows where in the given one each begins.
class KnotWalk {
public:
    /// `fine` are the given knots some steps later, `spans` those of the given ones. Both outlive the walk.
    KnotWalk(const Knots& given, const Spans& spans, const Knots& fine);
    /// The begin of the first, then of each next interval. There must be one: assert.
    KnotPlace next();
    /// The end of the last interval of those that come from the same given one.
    [[nodiscard]] KnotPlace end() const;

private:
    [[nodiscard]] std::uint64_t descendants(Symbol symbol);

    const Knots& given_;
    const Spans& spans_;
    const Knots& fine_;
    std::vector<DoubleDouble> fine_lengths_; ///< lengths of the fine knots by symbol, in units of `spans`
    std::vector<std::uint64_t> counts_;      ///< letters that a symbol becomes; 0 = not yet asked
    std::size_t next_;                       ///< place in the given word behind letter_
    std::size_t next_fine_;                  ///< place in the fine word behind the last interval
    std::size_t letter_ = 0;                 ///< letter of the given word that the last interval comes from
    Symbol fine_symbol_ = zero_interval;     ///< the last interval
    std::uint64_t left_ = 0;                 ///< fine intervals of `letter_` that are still to come
    DoubleDouble offset_;                    ///< begin of the last interval, from the begin of `letter_`
};

} // namespace internode
