// SPDX-License-Identifier: MIT
//
// What a step backwards is told and what it leaves: the choice of the left inverse A, and the details e of
//
//     f = P (c - A e) + e        (curve/reverse/reverse_step.h)

#pragma once

#include <cstddef>
#include <vector>

namespace internode {

enum class ReverseMethod { LeastSquares, Local };

struct ReverseOptions {
    ReverseMethod method = ReverseMethod::LeastSquares;
    std::size_t window = 5; ///< old intervals of a local filter: 3 to 5 do well up to degree 5
};

/// Details at some fine points, in ascending order; 0 at all others.
struct Details {
    std::vector<std::size_t> points; ///< fine points
    std::vector<double> vectors;     ///< a row each
};

} // namespace internode
