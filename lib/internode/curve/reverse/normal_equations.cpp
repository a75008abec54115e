// SPDX-License-Identifier: MIT
//
// PᵀP is kept as an envelope: of each row of its lower triangle the entries from the first one that is not 0.
// Cholesky's factor fills nothing outside it. On a ring the rows at the seam reach back to the front.

#include "internode/curve/reverse/normal_equations.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace internode {

NormalEquations::NormalEquations(const GatherMatrix& matrix)
    : first_(matrix.columns)
    , start_(matrix.columns + 1)
    , diagonal_(matrix.columns) {
    for (std::size_t k = 0; k < matrix.columns; ++k) first_[k] = k;
    for (const GatherRow& row : matrix.rows) {
        std::size_t least = matrix.columns;
        for (std::size_t i = 0; i < row.weights.size(); ++i)
            least = std::min(least, matrix.column(row.first + static_cast<std::ptrdiff_t>(i)));
        for (std::size_t i = 0; i < row.weights.size(); ++i) {
            std::size_t& first = first_[matrix.column(row.first + static_cast<std::ptrdiff_t>(i))];
            first = std::min(first, least);
        }
    }
    for (std::size_t k = 0; k < matrix.columns; ++k) start_[k + 1] = start_[k] + (k - first_[k]);
    lower_.assign(start_.back(), 0);
    add(matrix);
    factorise();
}

/// Every ordered pair of weights of a row goes to the lower triangle, so that a parent which occurs twice adds up.
void NormalEquations::add(const GatherMatrix& matrix) {
    for (const GatherRow& row : matrix.rows)
        for (std::size_t i = 0; i < row.weights.size(); ++i)
            for (std::size_t j = 0; j < row.weights.size(); ++j) {
                const std::size_t k = matrix.column(row.first + static_cast<std::ptrdiff_t>(i));
                const std::size_t m = matrix.column(row.first + static_cast<std::ptrdiff_t>(j));
                const double square = row.weights[i] * row.weights[j];
                if (k == m)
                    diagonal_[k] += square;
                else if (k > m)
                    entry(k, m) += square;
            }
}

void NormalEquations::factorise() {
    // A pivot that lost this much of its diagonal is what rounding left of 0.
    constexpr double lost = 1e3 * std::numeric_limits<double>::epsilon();
    for (std::size_t k = 0; k < diagonal_.size(); ++k) {
        double* const row = lower_.data() + start_[k];
        const std::size_t first = first_[k];
        for (std::size_t m = first; m < k; ++m) {
            const double* const other = lower_.data() + start_[m];
            double sum = row[m - first]; // becomes L D: the rows before are divided already
            for (std::size_t i = std::max(first, first_[m]); i < m; ++i) sum -= row[i - first] * other[i - first_[m]];
            row[m - first] = sum;
        }
        double pivot = diagonal_[k];
        for (std::size_t m = first; m < k; ++m) {
            const double scaled = row[m - first] / diagonal_[m];
            pivot -= row[m - first] * scaled;
            row[m - first] = scaled;
        }
        if (!(pivot > lost * diagonal_[k])) {
            regular_ = false;
            pivot = std::max(diagonal_[k], std::numeric_limits<double>::min()); // keeps the rest finite
        }
        diagonal_[k] = pivot;
    }
}

void NormalEquations::solve(std::vector<double>& rows, std::size_t dimension) const {
    assert(rows.size() == diagonal_.size() * dimension);
    const std::size_t n = diagonal_.size();
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t m = first_[k]; m < k; ++m)
            for (std::size_t c = 0; c < dimension; ++c)
                rows[k * dimension + c] -= lower_[start_[k] + (m - first_[k])] * rows[m * dimension + c];
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t c = 0; c < dimension; ++c) rows[k * dimension + c] /= diagonal_[k];
    for (std::size_t k = n; k-- > 0;)
        for (std::size_t m = first_[k]; m < k; ++m)
            for (std::size_t c = 0; c < dimension; ++c)
                rows[m * dimension + c] -= lower_[start_[k] + (m - first_[k])] * rows[k * dimension + c];
}

std::vector<double> least_squares(const GatherMatrix& matrix, const NormalEquations& equations,
                                  std::span<const double> b, std::size_t dimension) {
    constexpr int refinements = 2; // each gains as many digits as the condition left
    std::vector<double> x = transposed_product(matrix, b, dimension);
    equations.solve(x, dimension);
    std::vector<double> residual;
    std::vector<double> correction;
    for (int pass = 0; pass < refinements; ++pass) {
        put_product(matrix, x, dimension, residual);
        for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = b[i] - residual[i];
        put_transposed_product(matrix, residual, dimension, correction);
        equations.solve(correction, dimension);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
    }
    return x;
}

} // namespace internode
