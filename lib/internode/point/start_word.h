// SPDX-License-Identifier: MIT
//
// The word that a derivation starts from: of the axiom, or of a polygon.

#pragma once

#include "internode/point/module_word.h"
#include "internode/point/point_system.h"

#include <span>

namespace internode {

/// The word of the grammar's axiom. \throw std::invalid_argument when it has none, or when the system was made for the
/// input alone
[[nodiscard]] ModuleWord axiom_word(const PointSystem& system);

/// The word that the grammar's input makes of a polygon: rows of system.dimension() coordinates.
/// \throw std::invalid_argument for no point, another dimension, a parameter that would not be finite, and when the
/// system was made for the axiom alone
[[nodiscard]] ModuleWord input_word(const PointSystem& system, std::span<const double> points);

} // namespace internode
