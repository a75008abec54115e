// SPDX-License-Identifier: MIT
//
// The mask of a point grammar: what its rules do far from all ends, where they do the same to every point.

#pragma once

#include "internode/mask/uniform_mask.h"
#include "internode/point/compile/compile.h"

#include <optional>

namespace internode {

/// The mask of cells of one state, from their children; none where these have no weights.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const std::vector<CellChild>& children);

/// The mask of a grammar whose cells far from all ends cannot be told apart; none for others.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const CompiledGrammar& compiled);

/// The same of what compiles for many points; none for what does not.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const PointSystem& system);

} // namespace internode
