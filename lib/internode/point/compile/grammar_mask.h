// SPDX-License-Identifier: MIT
//
// The mask of a point grammar: what its rules do far from all ends, where they do the same to every point.

#pragma once

#include "internode/mask/uniform_mask.h"
#include "internode/point/compile/compiled_grammar.h"
#include "internode/point/point_system.h"

#include <optional>

namespace internode {

/// The mask of a grammar whose cells far from all ends cannot be told apart; none for others.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const CompiledGrammar& compiled);

/// The same of what compiles for many points; none for what does not.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const PointSystem& system);

} // namespace internode
