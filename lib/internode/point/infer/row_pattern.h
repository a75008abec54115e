// SPDX-License-Identifier: MIT
//
// What the inference of closed and of open curves asks of rows.

#pragma once

#include "internode/point/infer/inference.h"

#include <optional>

namespace internode {

/// Rows whose weights do not sum to 1.
[[nodiscard]] std::vector<std::size_t> rows_not_affine(const RationalMatrix& matrix);

/// A pattern that is too large to rank its shifts.
[[nodiscard]] std::optional<InferenceProblem> size_problem(const RowPattern& pattern);

} // namespace internode
