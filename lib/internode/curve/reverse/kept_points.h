// SPDX-License-Identifier: MIT
//
// Which fine points stand for the coarse ones, and which for the inserted knots.
//
// Every coarse point k keeps one fine point l_k with weight P[l_k, k] > 0, in the same order; the others, one per
// inserted knot, carry the details. P is totally positive, so the kept rows of an open curve are a regular matrix
// (Schoenberg and Whitney; Jia 1983 for knot insertion). Among all such choices the one with the least sum of
// 1 / P[l_k, k]: weights far from 0 keep that matrix well conditioned, at the ends too.

#pragma once

#include "internode/curve/reverse/gather_matrix.h"

namespace internode {

/// l_0 … l_{n_c - 1}. Open: ascending. Closed: ascending from l_0 on, going round. Cost: linear in the weights of P.
/// \throw std::invalid_argument when P has no such rows
[[nodiscard]] std::vector<std::size_t> kept_points(const GatherMatrix& matrix);

} // namespace internode
