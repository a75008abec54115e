// SPDX-License-Identifier: MIT
//
// A convergence measurement for a person at a terminal.

#pragma once

#include "internode/curve/convergence.h"

#include <string>

namespace internode {

[[nodiscard]] std::string convergence_text(const Convergence& convergence, const IntervalSystem& system);

/// What the envelope says about a tolerance, as a sentence; empty when none was asked for.
[[nodiscard]] std::string depth_sentence(const Convergence& convergence);

/// What an error costs in points, here and under uniform bisection, as a sentence; empty when there is no error.
[[nodiscard]] std::string bisection_sentence(const Convergence& convergence);

} // namespace internode
