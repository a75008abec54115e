// SPDX-License-Identifier: MIT
//
// One step of subdivision as the matrix P of its gather rows, in doubles: fine points = P * coarse points.
//
// P is n_f x n_c. A row holds the weights of consecutive coarse points, d+1 at most; where a closed word is shorter
// than a row, a point occurs several times in it and its weights add. P is never formed: everything below is linear in
// n_f, whatever the ends.

#pragma once

#include "internode/word/symbol.h"

#include <cstddef>
#include <span>
#include <vector>

namespace internode {

/// Weights of the points first, first + 1, …: modulo the number of points where the curve is closed.
struct GatherRow {
    std::ptrdiff_t first = 0;
    std::span<const double>
        weights; ///< weights from the first to the last that is not 0; lives as long as its hierarchy
};

struct GatherMatrix {
    Ends ends = Ends::Open;
    std::size_t columns = 0;     ///< n_c
    std::vector<GatherRow> rows; ///< n_f

    /// The coarse point that a parent index means.
    [[nodiscard]] std::size_t column(std::ptrdiff_t parent) const {
        const auto n = static_cast<std::ptrdiff_t>(columns);
        return static_cast<std::size_t>(parent >= 0 && parent < n ? parent : (parent % n + n) % n);
    }
    /// Whether every fine point is its coarse point.
    [[nodiscard]] bool is_identity() const;
};

/// P x: n_f rows of `dimension` numbers from n_c.
[[nodiscard]] std::vector<double> product(const GatherMatrix& matrix, std::span<const double> coarse,
                                          std::size_t dimension);

/// The same into `fine`, whose memory is used again.
void put_product(const GatherMatrix& matrix, std::span<const double> coarse, std::size_t dimension,
                 std::vector<double>& fine);

/// Pᵀ x: n_c rows from n_f.
[[nodiscard]] std::vector<double> transposed_product(const GatherMatrix& matrix, std::span<const double> fine,
                                                     std::size_t dimension);

/// The same into `coarse`, whose memory is used again.
void put_transposed_product(const GatherMatrix& matrix, std::span<const double> fine, std::size_t dimension,
                            std::vector<double>& coarse);

} // namespace internode
