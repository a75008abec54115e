// SPDX-License-Identifier: MIT
//
// Rewriting backwards: the word whose refinement (curve/refinement.h) is a given word. Not installed.
//
// The domain is cut into images of symbols, from the left; where two images fit, the first that lets the rest be cut is
// taken. Letters outside of an open domain are cut outwards; those that no fine letter shows repeat the last one seen.

#pragma once

#include "internode/curve/knots.h"

#include <optional>

namespace internode {

/// One step back; none when the word is no refinement. Cost: letters times symbols.
[[nodiscard]] std::optional<Word> coarser_word(const Morphism& rules, WordView fine, int degree, Ends ends);

} // namespace internode
