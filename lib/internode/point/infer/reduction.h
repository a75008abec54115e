// SPDX-License-Identifier: MIT
//
// Rings taken apart by the rules of a grammar that reduces by itself: strict predecessors of several points become one
// (Prusinkiewicz et al. 2003, section 7).

#pragma once

#include "internode/point/interpreter.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace internode {

/// Whether some rule makes less of several modules at once.
[[nodiscard]] bool reduces(const PointGrammar& grammar);

/// How many modules become one in every rule; 1 where the rules do not say it plainly.
[[nodiscard]] std::size_t reduced_arity(const PointGrammar& grammar);

struct Reduction {
    /// The polygon of each level down, rows of coordinates; an empty one, where no point is left, is the last.
    std::vector<std::vector<double>> polygons;
    std::optional<DerivationProblem> problem; ///< that ended it early
};

/// `levels` cycles of the grammar from a polygon of rows of system.dimension() coordinates, each read from module
/// `phase` of its ring on. \throw std::invalid_argument as input_word()
[[nodiscard]] Reduction reduced(const PointSystem& system, std::span<const double> points, std::uint64_t levels,
                                std::uint64_t phase);

} // namespace internode
