// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/gather_matrix.h"

#include <stdexcept>

namespace internode {

namespace {

void require_rows(std::span<const double> numbers, std::size_t rows, std::size_t dimension) {
    if (dimension == 0 || numbers.size() != rows * dimension)
        throw std::invalid_argument("the points are not as many as the matrix takes");
}

} // namespace

bool GatherMatrix::is_identity() const {
    if (rows.size() != columns) return false;
    for (std::size_t l = 0; l < rows.size(); ++l)
        if (rows[l].weights.size() != 1 || rows[l].weights[0] != 1 || column(rows[l].first) != l) return false;
    return true;
}

std::vector<double> product(const GatherMatrix& matrix, std::span<const double> coarse, std::size_t dimension) {
    std::vector<double> fine;
    put_product(matrix, coarse, dimension, fine);
    return fine;
}

void put_product(const GatherMatrix& matrix, std::span<const double> coarse, std::size_t dimension,
                 std::vector<double>& fine) {
    require_rows(coarse, matrix.columns, dimension);
    fine.assign(matrix.rows.size() * dimension, 0);
    double* out = fine.data();
    for (const GatherRow& row : matrix.rows) {
        std::ptrdiff_t parent = row.first;
        for (const double weight : row.weights) {
            const double* const in = coarse.data() + matrix.column(parent++) * dimension;
            for (std::size_t c = 0; c < dimension; ++c) out[c] += weight * in[c];
        }
        out += dimension;
    }
}

std::vector<double> transposed_product(const GatherMatrix& matrix, std::span<const double> fine,
                                       std::size_t dimension) {
    std::vector<double> coarse;
    put_transposed_product(matrix, fine, dimension, coarse);
    return coarse;
}

void put_transposed_product(const GatherMatrix& matrix, std::span<const double> fine, std::size_t dimension,
                            std::vector<double>& coarse) {
    require_rows(fine, matrix.rows.size(), dimension);
    coarse.assign(matrix.columns * dimension, 0);
    const double* in = fine.data();
    for (const GatherRow& row : matrix.rows) {
        std::ptrdiff_t parent = row.first;
        for (const double weight : row.weights) {
            double* const out = coarse.data() + matrix.column(parent++) * dimension;
            for (std::size_t c = 0; c < dimension; ++c) out[c] += weight * in[c];
        }
        in += dimension;
    }
}

} // namespace internode
