// SPDX-License-Identifier: MIT
//
// The loops of the kernel, included by one source per instruction set, which defines INTERNODE_VECTOR_BYTES.
//
// Everything here is in an unnamed namespace and uses nothing of the standard library that the linker could share with
// code compiled for another instruction set. A point of up to 8 coordinates is a few vectors: their store may spill
// over into the next point, which is written after it. Of up to 3, a group of rows as long as a vector is done at once,
// a coordinate after the other, and then interleaved. Wide points, whole rows of a grid, go past the caches when asked.

#include "internode/stencil/kernel.h"

#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace internode {
namespace {

template<typename Scalar, int Bytes>
struct VectorOf {
    typedef Scalar type __attribute__((vector_size(Bytes))); // NOLINT(modernize-use-using): no attribute there
};

/// The vectors that hold one point of `Dimension` coordinates: as few as the machine allows.
template<typename Scalar, int Dimension>
struct PointVectors {
    static constexpr int size = Dimension * static_cast<int>(sizeof(Scalar));
    static constexpr int whole = size <= 8 ? 8 : size <= 16 ? 16 : 32;
    static constexpr int bytes = whole < INTERNODE_VECTOR_BYTES ? whole : INTERNODE_VECTOR_BYTES;
    static constexpr int lanes = bytes / static_cast<int>(sizeof(Scalar));
    static constexpr int count = (size + bytes - 1) / bytes;
    /// The last of several ends with the point and begins among what the one before it has.
    static constexpr int first(int piece) {
        return count > 1 && piece + 1 == count ? Dimension - lanes : piece * lanes;
    }
    using Vector = typename VectorOf<Scalar, bytes>::type;
};

template<typename Vector, typename Scalar>
inline Vector load(const Scalar* from) {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
}

template<typename Vector, typename Scalar>
inline void store(const Vector& vector, Scalar* to) {
    std::memcpy(to, &vector, sizeof vector);
}

/// `rows` points from the same parents, which stay in registers.
template<typename Scalar, int Width, int Dimension>
inline void combine(const Scalar* parents, const Scalar* weights, std::size_t rows, Scalar* out) {
    using Point = PointVectors<Scalar, Dimension>;
    using Vector = typename Point::Vector;
    Vector parent[Width][Point::count];
    for (int k = 0; k < Width; ++k)
        for (int piece = 0; piece < Point::count; ++piece)
            parent[k][piece] = load<Vector>(parents + k * Dimension + Point::first(piece));
    for (std::size_t row = 0; row < rows; ++row) {
        for (int piece = 0; piece < Point::count; ++piece) {
            Vector sum = weights[0] * parent[0][piece];
            for (int k = 1; k < Width; ++k) sum = sum + weights[k] * parent[k][piece];
            store(sum, out + Point::first(piece));
        }
        weights += Width;
        out += Dimension;
    }
}

/// The lanes I… of the two vectors, counted through both, in each of their 16 bytes.
template<int... I, typename Vector>
inline Vector in_blocks(const Vector& a, const Vector& b) {
    constexpr int n = sizeof...(I);
    if constexpr (sizeof(Vector) == 16)
        return __builtin_shufflevector(a, b, I...);
    else
        return __builtin_shufflevector(a, b, (I < n ? I : I + n)..., (I < n ? I + n : I + 2 * n)...);
}

template<int First, int Second, typename Vector, int... I>
inline Vector halves(const Vector& a, const Vector& b, std::integer_sequence<int, I...>) {
    constexpr int n = sizeof...(I);
    return __builtin_shufflevector(a, b, (First * n + I)..., (2 * n + Second * n + I)...);
}

/// Half `First` of a, and half `Second` of b.
template<typename Scalar, int First, int Second, typename Vector>
inline Vector halves(const Vector& a, const Vector& b) {
    constexpr int n = static_cast<int>(sizeof(Vector) / sizeof(Scalar) / 2);
    return halves<First, Second>(a, b, std::make_integer_sequence<int, n>());
}

/// The coordinates of as many points as a vector has lanes, point after point.
template<typename Scalar, typename Vector>
inline void interleave(const Vector (&x)[1], Scalar* out) {
    store(x[0], out);
}

template<typename Scalar, typename Vector>
inline void interleave(const Vector (&x)[2], Scalar* out) {
    constexpr int lanes = sizeof(Vector) / sizeof(Scalar);
    Vector low;
    Vector high;
    if constexpr (sizeof(Scalar) == 8) {
        low = in_blocks<0, 2>(x[0], x[1]);
        high = in_blocks<1, 3>(x[0], x[1]);
    } else {
        low = in_blocks<0, 4, 1, 5>(x[0], x[1]);
        high = in_blocks<2, 6, 3, 7>(x[0], x[1]);
    }
    if constexpr (sizeof(Vector) == 16) {
        store(low, out);
        store(high, out + lanes);
    } else {
        store(halves<Scalar, 0, 0>(low, high), out);
        store(halves<Scalar, 1, 1>(low, high), out + lanes);
    }
}

template<typename Scalar, typename Vector>
inline void interleave(const Vector (&x)[3], Scalar* out) {
    constexpr int lanes = sizeof(Vector) / sizeof(Scalar);
    Vector first;
    Vector second;
    Vector third;
    if constexpr (sizeof(Scalar) == 8) {
        first = in_blocks<0, 2>(x[0], x[1]);
        second = in_blocks<0, 3>(x[2], x[0]);
        third = in_blocks<1, 3>(x[1], x[2]);
    } else {
        const Vector even = in_blocks<0, 2, 4, 6>(x[0], x[1]);
        const Vector odd = in_blocks<1, 3, 5, 7>(x[1], x[2]);
        const Vector both = in_blocks<0, 2, 5, 7>(x[2], x[0]);
        first = in_blocks<0, 2, 4, 6>(even, both);
        second = in_blocks<0, 2, 5, 7>(odd, even);
        third = in_blocks<1, 3, 5, 7>(both, odd);
    }
    if constexpr (sizeof(Vector) == 16) {
        store(first, out);
        store(second, out + lanes);
        store(third, out + 2 * lanes);
    } else {
        store(halves<Scalar, 0, 0>(first, second), out);
        store(halves<Scalar, 0, 1>(third, first), out + lanes);
        store(halves<Scalar, 1, 1>(second, third), out + 2 * lanes);
    }
}

template<typename Scalar>
constexpr std::size_t vector_lanes = INTERNODE_VECTOR_BYTES / sizeof(Scalar);

/// Points of more coordinates are whole vectors by themselves.
template<typename Scalar, int Dimension>
constexpr std::size_t rows_of_group = Dimension <= 3 ? vector_lanes<Scalar> : 1;

/// `groups` groups of rows from the same parents, each of whose coordinates fills a vector.
template<typename Scalar, int Width, int Dimension>
inline void combine_groups(const Scalar* parents, const Scalar* weights, std::size_t groups, Scalar* out) {
    using Vector = typename VectorOf<Scalar, INTERNODE_VECTOR_BYTES>::type;
    constexpr std::size_t lanes = vector_lanes<Scalar>;
    Vector parent[Width][Dimension];
    for (int k = 0; k < Width; ++k)
        for (int c = 0; c < Dimension; ++c) parent[k][c] = parents[k * Dimension + c] - Vector{}; // in every lane
    for (std::size_t group = 0; group < groups; ++group) {
        Vector sum[Dimension];
        const Vector first = load<Vector>(weights);
        for (int c = 0; c < Dimension; ++c) sum[c] = first * parent[0][c];
        for (int k = 1; k < Width; ++k) {
            const Vector weight = load<Vector>(weights + static_cast<std::size_t>(k) * lanes);
            for (int c = 0; c < Dimension; ++c) sum[c] = sum[c] + weight * parent[k][c];
        }
        interleave(sum, out);
        weights += Width * lanes;
        out += Dimension * lanes;
    }
}

/// What of a cell has been done.
template<typename Scalar>
struct Progress {
    const Scalar* weights;
    std::size_t rows; ///< that are left
    Scalar* out;
};

/// The groups of a cell; its other rows are left.
template<typename Scalar, int Width, int Dimension>
inline Progress<Scalar> do_groups(const CellWork<Scalar>& cell, Scalar* out) {
    if constexpr (Dimension <= 3) {
        if (cell.groups > 0) {
            combine_groups<Scalar, Width, Dimension>(cell.parents, cell.weights, cell.groups, out);
            const std::size_t done = cell.groups * vector_lanes<Scalar>;
            return {cell.weights + done * Width, cell.rows - done, out + done * Dimension};
        }
    }
    return {cell.weights, cell.rows, out};
}

/// A whole vector to an address that is a multiple of its size, past the caches.
template<typename Vector, typename Scalar>
inline void stream(const Vector& vector, Scalar* to) {
#if defined(__AVX__)
    _mm256_stream_si256(reinterpret_cast<__m256i*>(to), (__m256i)vector);
#elif defined(__SSE2__)
    _mm_stream_si128(reinterpret_cast<__m128i*>(to), (__m128i)vector);
#else
    store(vector, to);
#endif
}

/// Streamed bytes are seen by other threads only after this.
inline void fence(Store store) {
#if defined(__SSE2__)
    if (store == Store::Streamed) _mm_sfence();
#else
    (void)store;
#endif
}

/// Straight to their place; the last point, which has nobody after it to write over its spill, by way of the stack.
template<typename Scalar, int Width, int Dimension>
void refine_small(const CellWork<Scalar>* cells, std::size_t count, std::size_t, Scalar* out, Store) {
    const CellWork<Scalar>* const last = cells + count - 1;
    for (const CellWork<Scalar>* cell = cells; cell != last; ++cell) {
        const Progress<Scalar> at = do_groups<Scalar, Width, Dimension>(*cell, out);
        combine<Scalar, Width, Dimension>(cell->parents, at.weights, at.rows, at.out);
        out = at.out + at.rows * Dimension;
    }
    const Progress<Scalar> at = do_groups<Scalar, Width, Dimension>(*last, out);
    if (at.rows == 0) return; // a group spills nothing
    combine<Scalar, Width, Dimension>(last->parents, at.weights, at.rows - 1, at.out);
    Scalar point[Dimension + padding_bytes / sizeof(Scalar)];
    combine<Scalar, Width, Dimension>(last->parents, at.weights + (at.rows - 1) * Width, 1, point);
    std::memcpy(at.out + (at.rows - 1) * Dimension, point, sizeof(Scalar) * Dimension);
}

/// Each cell to the stage, where a spill does no harm.
template<typename Scalar, int Width, int Dimension>
void stage_small(const CellWork<Scalar>* cells, std::size_t count, std::size_t, LineWriter<Scalar>& out) {
    constexpr std::size_t group = rows_of_group<Scalar, Dimension>;
    constexpr std::size_t most = (LineWriter<Scalar>::capacity - LineWriter<Scalar>::line) / Dimension / group * group;
    LineWriter<Scalar> writer = out;
    for (const CellWork<Scalar>* cell = cells; cell != cells + count; ++cell) {
        CellWork<Scalar> rest = *cell;
        while (rest.rows > 0) {
            CellWork<Scalar> part = rest;
            if (part.rows > most) part.rows = most;
            if (part.groups > most / group) part.groups = most / group;
            const Progress<Scalar> at = do_groups<Scalar, Width, Dimension>(part, writer.next(part.rows * Dimension));
            combine<Scalar, Width, Dimension>(cell->parents, at.weights, at.rows, at.out);
            writer.wrote(part.rows * Dimension);
            rest.weights += part.rows * Width;
            rest.rows -= part.rows;
            rest.groups -= part.groups;
        }
    }
    out = writer;
}

template<typename Scalar>
inline Scalar column_sum(const Scalar* parents, const Scalar* weights, std::size_t width, std::size_t dimension) {
    Scalar sum = weights[0] * parents[0];
    for (std::size_t k = 1; k < width; ++k) sum = sum + weights[k] * parents[k * dimension];
    return sum;
}

/// `columns` coordinates of one new point, Width 0 for any width.
template<typename Scalar, int Width>
inline void combine_columns(const Scalar* parents, const Scalar* weights, std::size_t any_width, std::size_t dimension,
                            std::size_t columns, Scalar* out, Store store) {
    using Vector = typename VectorOf<Scalar, INTERNODE_VECTOR_BYTES>::type;
    constexpr std::size_t lanes = vector_lanes<Scalar>;
    const std::size_t width = Width == 0 ? any_width : static_cast<std::size_t>(Width);
    const auto sums = [=](std::size_t column) {
        Vector sum = weights[0] * load<Vector>(parents + column);
        for (std::size_t k = 1; k < width; ++k) sum = sum + weights[k] * load<Vector>(parents + k * dimension + column);
        return sum;
    };
    std::size_t column = 0;
    if (store == Store::Cached && columns >= lanes && columns <= 8 * lanes) { // too short for an aligned middle
        for (; column + lanes < columns; column += lanes) internode::store(sums(column), out + column);
        return internode::store(sums(columns - lanes), out + columns - lanes); // some of them once more
    }
    while (column < columns && reinterpret_cast<std::uintptr_t>(out + column) % INTERNODE_VECTOR_BYTES != 0) {
        out[column] = column_sum(parents + column, weights, width, dimension);
        ++column;
    }
    for (; column + lanes <= columns; column += lanes) {
        if (store == Store::Streamed)
            stream(sums(column), out + column);
        else
            internode::store(sums(column), out + column);
    }
    for (; column < columns; ++column) out[column] = column_sum(parents + column, weights, width, dimension);
}

/// Points of any dimension, whole rows of a grid among them, in blocks of columns.
template<typename Scalar, int Width>
void refine_wide(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension, Scalar* out, Store store,
                 std::size_t width) {
    // So wide, the parents stay in the second cache while a cell's rows are written, each in long stretches.
    const std::size_t block = 131072 / sizeof(Scalar) / width;
    for (const CellWork<Scalar>* cell = cells; cell != cells + count; ++cell) {
        for (std::size_t first = 0; first < dimension; first += block) {
            const std::size_t columns = dimension - first < block ? dimension - first : block;
            for (std::size_t row = 0; row < cell->rows; ++row)
                combine_columns<Scalar, Width>(cell->parents + first, cell->weights + row * width, width, dimension,
                                               columns, out + row * dimension + first, store);
        }
        out += cell->rows * dimension;
    }
    fence(store);
}

template<typename Scalar, int Width>
void refine_any(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension, Scalar* out, Store store) {
    refine_wide<Scalar, Width>(cells, count, dimension, out, store, Width);
}

/// Points of any dimension up to staged_point_bytes, row by row to the stage.
template<typename Scalar, int Width>
void stage_any(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension, LineWriter<Scalar>& out) {
    LineWriter<Scalar> writer = out;
    for (const CellWork<Scalar>* cell = cells; cell != cells + count; ++cell) {
        for (std::size_t row = 0; row < cell->rows; ++row) {
            combine_columns<Scalar, Width>(cell->parents, cell->weights + row * Width, Width, dimension, dimension,
                                           writer.next(dimension), Store::Cached);
            writer.wrote(dimension);
        }
    }
    out = writer;
}

template<typename Scalar, int Width, int Dimension>
constexpr Kernels<Scalar> small_kernels = {rows_of_group<Scalar, Dimension>, refine_small<Scalar, Width, Dimension>,
                                           stage_small<Scalar, Width, Dimension>};

template<typename Scalar, int Width>
constexpr Kernels<Scalar> any_kernels = {1, refine_any<Scalar, Width>, stage_any<Scalar, Width>};

template<typename Scalar, int Width>
Kernels<Scalar> of_dimension(std::size_t dimension) {
    switch (dimension) {
    case 1:
        return small_kernels<Scalar, Width, 1>;
    case 2:
        return small_kernels<Scalar, Width, 2>;
    case 3:
        return small_kernels<Scalar, Width, 3>;
    case 4:
        return small_kernels<Scalar, Width, 4>;
    case 5:
        return small_kernels<Scalar, Width, 5>;
    case 6:
        return small_kernels<Scalar, Width, 6>;
    case 7:
        return small_kernels<Scalar, Width, 7>;
    case 8:
        return small_kernels<Scalar, Width, 8>;
    default:
        return any_kernels<Scalar, Width>;
    }
}

template<typename Scalar>
Kernels<Scalar> of_width(std::size_t width, std::size_t dimension) {
    switch (width) {
    case 2:
        return of_dimension<Scalar, 2>(dimension);
    case 3:
        return of_dimension<Scalar, 3>(dimension);
    case 4:
        return of_dimension<Scalar, 4>(dimension);
    case 5:
        return of_dimension<Scalar, 5>(dimension);
    case 6:
        return of_dimension<Scalar, 6>(dimension);
    case 7:
        return of_dimension<Scalar, 7>(dimension);
    case 8:
        return of_dimension<Scalar, 8>(dimension);
    case 9:
        return of_dimension<Scalar, 9>(dimension);
    case 10:
        return of_dimension<Scalar, 10>(dimension);
    case 11:
        return of_dimension<Scalar, 11>(dimension);
    case 12:
        return of_dimension<Scalar, 12>(dimension);
    case 13:
        return of_dimension<Scalar, 13>(dimension);
    default:
        return {};
    }
}

} // namespace
} // namespace internode
