// SPDX-License-Identifier: MIT
//
// What follows from the mask of a uniform scheme, for a person at a terminal.

#pragma once

#include "internode/point/check/point_validation.h"

#include <string>

namespace internode {

/// Labelled lines: mask, symbol, support, degrees, names, convergence, smoothness.
[[nodiscard]] std::string mask_facts_text(const MaskFacts& facts);

/// "proved: the differences of order 1 shrink …".
[[nodiscard]] std::string convergence_text(const Smoothness& smoothness);

/// "C^1 (proved); Hölder exponent 2 (proved)", with what is proved and what is estimated.
[[nodiscard]] std::string smoothness_text(const Smoothness& smoothness);

} // namespace internode
