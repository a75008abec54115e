// SPDX-License-Identifier: MIT
//
// Which modules stay because no rule fits, where rules elsewhere make several points of the same letter.
//
// "No rule" is the identity (Prusinkiewicz et al. 2003, section 6), which is how ends of open curves stay where they
// are; but a module further inside that stays was forgotten. The contexts are found by exploration: derivations of the
// axiom and of inputs of 1 … 12 points, a few cycles each, looking as far as the contexts of the rules reach. A module
// whose letters fit a rule but not its condition is meant to stay.

#pragma once

#include "internode/point/interpreter.h"
#include "internode/point/point_system.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace internode {

struct StayingContext {
    std::optional<std::uint32_t> table; ///< whose rules these are; none without tables
    Symbol letter{};
    Word left; ///< letters before the module on its axis, as far as rules for its letter look, in the order of the word
    Word right;
    bool outermost = false;   ///< the first or the last point of an open axis: an end that stays
    std::size_t smallest = 0; ///< number of input points of the first derivation with it; 0: the axiom
    std::size_t largest = 0;  ///< the same of the last derivation with it
    std::uint64_t step = 0;   ///< the step of the first derivation that meets it, from 0
    std::size_t module = 0;   ///< number of the module in the word before that step, from 0
};

struct Coverage {
    std::size_t points = 0;              ///< inputs of 1 … so many points were derived; 0: the axiom alone
    std::uint64_t cycles = 0;            ///< cycles that each derivation runs at most
    std::vector<StayingContext> staying; ///< contexts in the order in which they were found, at most 100
    std::vector<std::uint32_t> unused;   ///< rules that were never applied
    /// Numbers of input points (0: the axiom) from which no point inside the word stays, while others multiply.
    std::vector<std::size_t> complete;
    std::vector<std::size_t> incomplete; ///< numbers of input points from which one does stay
    /// Nothing stays inside the word for some number of points, or nothing multiplies at all: a grammar for polygons of
    /// three points need not know what to do with four.
    bool ends_complete = true;
    std::optional<DerivationProblem> problem; ///< the first that ended a derivation early
    std::size_t problem_points = 0;           ///< its number of input points; 0: the axiom
};

/// Cost: bounded, about 0.1 s for the longest words that are explored.
[[nodiscard]] Coverage coverage(const PointSystem& system);

} // namespace internode
