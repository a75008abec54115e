// SPDX-License-Identifier: MIT
//
// From a knot vector to a word: one letter per interval between successive knots, equal knots give `0`.
//
// Open, degree d, N points: t_0 <= … <= t_{N+d}, letter k is [t_k, t_{k+1}]. The short form has the N + d - 1 knots
// t_1 … t_{N+d-1}, without the two that no curve depends on: the first and last letter are then `0`. Closed: t_0 … t_N,
// one period. Point k has the support [t_k, t_{k+d+1}] either way.
//
// Symbols: a grammar A -> A…A of one symbol says how any interval splits, and gets a symbol A1, A2, … per distinct
// length, in order of appearance (Nivoliers et al. 2012, 3.3.2; Sederberg et al. 1998). Any other grammar must fit:
// every interval equals the length of exactly one symbol, at one scale of the one final class whose scale is open.
// Equality is exact equality in K throughout.

#pragma once

#include "internode/interval/interval_system.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

struct KnotVector {
    int degree = 3; ///< >= 1
    Ends ends = Ends::Open;
    std::size_t points = 0;      ///< N >= 1
    std::vector<Number> knots;   ///< rational, or in the field of the system
    std::vector<Symbol> fixed{}; ///< symbols whose lengths have been said, besides those that the grammar declares
};

struct KnotWord {
    IntervalSystem system; ///< the system with the lengths that the knots say
    Word word;             ///< N + d letters, N when closed
    Number origin{};       ///< the knot where the domain begins
};

struct FittedKnots {
    std::optional<KnotWord> fitted; ///< the word, when everything fits
    std::vector<std::string>
        problems; ///< what does not fit, each a sentence with the numbers; knots are counted from 1
};

/// Refused: another number of knots, knots that decrease, a multiplicity above d + 1 at an end (d in the short form) or
/// above d inside. Also a domain t_d … t_N that begins or ends with an empty interval, intervals that no symbol fits or
/// that several fit, a scale that stays open. Cost: N log of the number of distinct lengths, in exact arithmetic.
[[nodiscard]] FittedKnots fit_knots(const IntervalSystem& system, const KnotVector& knots);

} // namespace internode
