// SPDX-License-Identifier: MIT
//
// Logarithms without libm, whose last digits differ between machines (docs/promises.md, P10).

#pragma once

namespace internode {

/// log10 of a positive finite number, to about 1e-15.
[[nodiscard]] double decimal_logarithm(double value);

} // namespace internode
