// SPDX-License-Identifier: MIT
//
// The uniform mask of cells that all do the same: of a state whose children are its own, and of the interval grammars
// with one symbol, A -> A … A with m letters. At degree d the mask of these is that of the uniform B-splines,
//
//     Σ a_k z^k = z^first ((1 + z + … + z^(m-1)) / m)^(d+1) m.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/mask/uniform_mask.h"
#include "internode/stencil/cell_rules.h"

#include <optional>
#include <vector>

namespace internode {

/// The mask of cells of one state, from their children; none where these have no weights. Weights are rational.
[[nodiscard]] std::optional<UniformMask> uniform_mask(const std::vector<CellChild>& children);

/// The mask of a grammar with one symbol at that degree; none for several symbols, whose points do not all do the same.
/// \throw std::invalid_argument for a degree below 1
[[nodiscard]] std::optional<UniformMask> uniform_mask(const IntervalSystem& system, int degree);

} // namespace internode
