// SPDX-License-Identifier: MIT
//
// The matrix of one step for a given word: new points = matrix * old points, exact.
//
// Rows are the stencils of the new points in order (d+1 entries each, fewer where a short closed word wraps and a
// parent occurs several times: its weights add). Columns are the masks of the old ones.

#pragma once

#include "internode/interval/interval_system.h"

#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace internode {

struct StepMatrix {
    struct Entry {
        std::uint64_t row;    ///< new point, from 0
        std::uint64_t column; ///< old point, from 0
        Number weight;        ///< > 0
    };
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
    std::vector<Entry> entries; ///< entries that are not 0, by row, then by column
};

/// Of a word that fits the degree (curve/curve.h): N letters circular, N + d open, N points. \throw TooManyStates
[[nodiscard]] StepMatrix step_matrix(const IntervalSystem& system, int degree, WordView word, Ends ends);

/// The same with every weight rounded to the nearest double: rows x columns, ready to be applied or factorised.
/// \throw std::length_error beyond 2^31 - 1 rows, columns or entries
[[nodiscard]] Eigen::SparseMatrix<double, Eigen::RowMajor> sparse(const StepMatrix& matrix);

} // namespace internode
