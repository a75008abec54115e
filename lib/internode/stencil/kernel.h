// SPDX-License-Identifier: MIT
//
// The numeric kernel: points of any dimension, gathered from d+1 consecutive parents.
//
//     out_r[c] = ((w_r0 p_0[c] + w_r1 p_1[c]) + w_r2 p_2[c]) + …      all d+1 products, in this order
//
// One source (kernel_loops.h), compiled once for every machine and once with AVX2 but without FMA. Every lane does the
// same IEEE operations in the same order, so the bytes do not depend on which one runs (docs/promises.md, P10).

#pragma once

#include "internode/stencil/isa.h"
#include "internode/stencil/line_writer.h"

#include <cstddef>

namespace internode {

/// The rows of one cell: `rows` new points from the d+1 parents that start at `parents`.
template<typename Scalar>
struct CellWork {
    const Scalar* parents;
    const Scalar* weights; ///< width a row; in groups weight after weight, each of all rows of the group
    std::size_t rows;
    std::size_t groups; ///< of Kernels::group rows, that the first rows stand in
};

/// How a kernel writes by itself: by ordinary stores, or, points of more than 8 coordinates, past the caches.
enum class Store { Cached, Streamed };

/// Writes the new points of `count` cells one after the other, rows of `dimension` coordinates. A parent of less than
/// 32 bytes may be read up to 32 bytes from its start: padding_bytes behind the last point are the caller's.
template<typename Scalar>
using Kernel = void (*)(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension, Scalar* out,
                        Store store);

/// The same by way of a stage; no point has more than staged_point_bytes.
template<typename Scalar>
using StagedKernel = void (*)(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension,
                              LineWriter<Scalar>& out);

/// Both do cells with groups and without.
template<typename Scalar>
struct Kernels {
    std::size_t group = 1; ///< rows of a cell that are done at once, a power of two; 1: groups are not wanted
    Kernel<Scalar> direct = nullptr;
    StagedKernel<Scalar> staged = nullptr;
};

/// Longer points, rows of a grid among them, need no stage: both their ends are little beside them.
inline constexpr std::size_t staged_point_bytes = 1024;

/// Bytes behind the last parent that must be readable.
inline constexpr std::size_t padding_bytes = 32;

/// The widest rows that a kernel takes: degree 12.
inline constexpr std::size_t max_row_width = 13;

/// The kernels of rows of `width` weights, 2 … max_row_width. \throw std::invalid_argument for others
template<typename Scalar>
[[nodiscard]] Kernels<Scalar> kernels(Isa isa, std::size_t width, std::size_t dimension);

} // namespace internode
