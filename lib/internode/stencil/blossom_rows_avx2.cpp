// SPDX-License-Identifier: MIT

#include "internode/stencil/blossom_loops.h"

namespace internode {
namespace {

typedef double FourLanes __attribute__((vector_size(32))); // NOLINT(modernize-use-using): no attribute there

} // namespace

double blossom_rows_avx2(const PieceView& piece, const double* hi, const double* lo, std::size_t rows,
                         double* weights) {
    return blossom_rows_by_lanes<FourLanes>(piece, hi, lo, rows, weights);
}

} // namespace internode
