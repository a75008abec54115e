// SPDX-License-Identifier: MIT

#include "internode/stencil/blossom_rows.h"

#include "internode/stencil/blossom_loops.h"

#include <cassert>

namespace internode {
namespace {

/// What every processor of the machines here has.
typedef double TwoLanes __attribute__((vector_size(16))); // NOLINT(modernize-use-using): no attribute there

} // namespace

double blossom_rows(const BlossomPiece& piece, const PairArray& arguments, std::size_t rows, double* weights,
                    [[maybe_unused]] Isa isa) {
    assert(arguments.hi.size() >= rows + piece.degree - 1 + blossom_padding);
    const PieceView view{piece.degree, piece.knots.hi.data(), piece.knots.lo.data()};
#if defined(INTERNODE_HAS_AVX2)
    if (usable(isa) == Isa::Avx2)
        return blossom_rows_avx2(view, arguments.hi.data(), arguments.lo.data(), rows, weights);
#endif
    return blossom_rows_by_lanes<TwoLanes>(view, arguments.hi.data(), arguments.lo.data(), rows, weights);
}

} // namespace internode
