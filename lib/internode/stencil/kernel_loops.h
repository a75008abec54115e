// SPDX-License-Identifier: MIT
//
// The loops of the kernel, included by one source per instruction set, which defines INTERNODE_VECTOR_BYTES.
//
// Everything here is in an unnamed namespace and uses nothing of the standard library that the linker could share with
// code compiled for another instruction set. A point of 2 to 4 coordinates is one short vector: its store may spill
// over into the next point, which is written after it. Wide points, whole rows of a grid, go past the caches when
// asked.

#include "internode/stencil/kernel.h"

#include <cstdint>
#include <cstring>

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
            parent[k][piece] = load<Vector>(parents + k * Dimension + piece * Point::lanes);
    for (std::size_t row = 0; row < rows; ++row) {
        for (int piece = 0; piece < Point::count; ++piece) {
            Vector sum = weights[0] * parent[0][piece];
            for (int k = 1; k < Width; ++k) sum = sum + weights[k] * parent[k][piece];
            store(sum, out + piece * Point::lanes);
        }
        weights += Width;
        out += Dimension;
    }
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
        combine<Scalar, Width, Dimension>(cell->parents, cell->weights, cell->rows, out);
        out += cell->rows * Dimension;
    }
    combine<Scalar, Width, Dimension>(last->parents, last->weights, last->rows - 1, out);
    out += (last->rows - 1) * Dimension;
    Scalar point[Dimension + padding_bytes / sizeof(Scalar)];
    combine<Scalar, Width, Dimension>(last->parents, last->weights + (last->rows - 1) * Width, 1, point);
    std::memcpy(out, point, sizeof(Scalar) * Dimension);
}

/// Each cell to the stage, where a spill does no harm.
template<typename Scalar, int Width, int Dimension>
void stage_small(const CellWork<Scalar>* cells, std::size_t count, std::size_t, LineWriter<Scalar>& out) {
    LineWriter<Scalar> writer = out;
    for (const CellWork<Scalar>* cell = cells; cell != cells + count; ++cell) {
        constexpr std::size_t most = (LineWriter<Scalar>::capacity - LineWriter<Scalar>::line) / Dimension;
        const Scalar* weights = cell->weights;
        for (std::size_t rest = cell->rows; rest > 0;) {
            const std::size_t rows = rest < most ? rest : most;
            combine<Scalar, Width, Dimension>(cell->parents, weights, rows, writer.next(rows * Dimension));
            writer.wrote(rows * Dimension);
            weights += rows * Width;
            rest -= rows;
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
    constexpr std::size_t lanes = INTERNODE_VECTOR_BYTES / sizeof(Scalar);
    const std::size_t width = Width == 0 ? any_width : static_cast<std::size_t>(Width);
    std::size_t column = 0;
    while (column < columns && reinterpret_cast<std::uintptr_t>(out + column) % INTERNODE_VECTOR_BYTES != 0) {
        out[column] = column_sum(parents + column, weights, width, dimension);
        ++column;
    }
    for (; column + lanes <= columns; column += lanes) {
        Vector sum = weights[0] * load<Vector>(parents + column);
        for (std::size_t k = 1; k < width; ++k) sum = sum + weights[k] * load<Vector>(parents + k * dimension + column);
        if (store == Store::Streamed)
            stream(sum, out + column);
        else
            internode::store(sum, out + column);
    }
    for (; column < columns; ++column) out[column] = column_sum(parents + column, weights, width, dimension);
}

/// Points of any dimension, whole rows of a grid among them, in blocks of columns.
template<typename Scalar, int Width>
void refine_wide(const CellWork<Scalar>* cells, std::size_t count, std::size_t dimension, Scalar* out, Store store,
                 std::size_t width) {
    constexpr std::size_t block = 4096 / sizeof(Scalar); // so wide, `width` parents stay in the first cache
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
constexpr Kernels<Scalar> small_kernels = {refine_small<Scalar, Width, Dimension>,
                                           stage_small<Scalar, Width, Dimension>};

template<typename Scalar, int Width>
constexpr Kernels<Scalar> any_kernels = {refine_any<Scalar, Width>, stage_any<Scalar, Width>};

template<typename Scalar, int Width>
Kernels<Scalar> of_dimension(std::size_t dimension) {
    switch (dimension) {
    case 2:
        return small_kernels<Scalar, Width, 2>;
    case 3:
        return small_kernels<Scalar, Width, 3>;
    case 4:
        return small_kernels<Scalar, Width, 4>;
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
        return any_kernels<Scalar, 9>;
    case 10:
        return any_kernels<Scalar, 10>;
    case 11:
        return any_kernels<Scalar, 11>;
    case 12:
        return any_kernels<Scalar, 12>;
    case 13:
        return any_kernels<Scalar, 13>;
    default:
        return {};
    }
}

} // namespace
} // namespace internode
