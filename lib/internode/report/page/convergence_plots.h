// SPDX-License-Identifier: MIT
//
// The two plots of a convergence report (report/page/convergence_page.h).

#pragma once

#include "internode/curve/convergence.h"

#include <string>

namespace internode {

/// Error and envelope against points, with the slope -2 and uniform bisection; empty when every error is 0.
[[nodiscard]] std::string error_plot(const Convergence& convergence);

/// Ratio of successive errors against the step, with 1/ρ²; empty when there is none.
[[nodiscard]] std::string ratio_plot(const Convergence& convergence, const std::string& ratio_name);

} // namespace internode
