// SPDX-License-Identifier: MIT

#include "internode/stencil/kernel.h"

#include "tests/fixtures/random_curve.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace internode {
namespace {

using tests::Random;

template<typename Scalar>
struct Job {
    std::size_t width;
    std::size_t dimension;
    std::vector<std::size_t> rows;              ///< per cell
    std::vector<Scalar> parents;                ///< cell i starts at parent i
    std::vector<std::vector<Scalar>> weights{}; ///< per cell, width a row
};

template<typename Scalar>
Job<Scalar> random_job(std::size_t width, std::size_t dimension, Random& random) {
    Job<Scalar> job{width, dimension, {1, 2, 1, 40, 3, 7}, {}};
    job.parents.resize((job.rows.size() + width) * dimension + padding_bytes);
    for (Scalar& coordinate : job.parents) coordinate = static_cast<Scalar>(random.coordinate());
    for (const std::size_t rows : job.rows) {
        job.weights.emplace_back(rows * width);
        for (Scalar& weight : job.weights.back()) weight = static_cast<Scalar>(random.coordinate());
    }
    return job;
}

/// The sum as kernel.h defines it, one coordinate at a time.
template<typename Scalar>
std::vector<Scalar> expected(const Job<Scalar>& job) {
    std::vector<Scalar> out;
    for (std::size_t cell = 0; cell < job.rows.size(); ++cell)
        for (std::size_t row = 0; row < job.rows[cell]; ++row)
            for (std::size_t c = 0; c < job.dimension; ++c) {
                const Scalar* const weights = job.weights[cell].data() + row * job.width;
                const Scalar* const parents = job.parents.data() + cell * job.dimension + c;
                volatile Scalar sum = weights[0] * parents[0]; // volatile: every operation rounds
                for (std::size_t k = 1; k < job.width; ++k) {
                    volatile const Scalar product = weights[k] * parents[k * job.dimension];
                    sum = sum + product;
                }
                out.push_back(Scalar(sum));
            }
    return out;
}

enum class Way { Cached, Streamed, Staged };

/// The kernel's points, written `shift` scalars behind a cache line between guards that must survive.
template<typename Scalar>
std::vector<Scalar> computed(const Job<Scalar>& job, Isa isa, Way way, std::size_t shift, std::size_t size) {
    constexpr std::size_t guard = 16;
    const Scalar untouched(7);
    std::vector<Scalar> memory(size + 3 * guard + shift, untouched);
    const std::size_t misplaced = reinterpret_cast<std::uintptr_t>(memory.data()) / sizeof(Scalar) % guard;
    const std::size_t first = 2 * guard - misplaced + shift;
    std::vector<CellWork<Scalar>> work;
    for (std::size_t cell = 0; cell < job.rows.size(); ++cell)
        work.push_back({job.parents.data() + cell * job.dimension, job.weights[cell].data(), job.rows[cell]});
    const Kernels<Scalar> chosen = kernels<Scalar>(isa, job.width, job.dimension);
    if (way == Way::Staged) {
        LineStage<Scalar> stage;
        LineWriter<Scalar> writer(stage, memory.data() + first);
        const std::size_t half = work.size() / 2;
        chosen.staged(work.data(), half, job.dimension, writer);
        chosen.staged(work.data() + half, work.size() - half, job.dimension, writer);
        writer.finish();
    } else {
        chosen.direct(work.data(), work.size(), job.dimension, memory.data() + first,
                      way == Way::Cached ? Store::Cached : Store::Streamed);
    }
    for (std::size_t i = 0; i < memory.size(); ++i)
        EXPECT_TRUE((i >= first && i < first + size) || memory[i] == untouched) << "written outside, at " << i;
    return {memory.begin() + static_cast<std::ptrdiff_t>(first),
            memory.begin() + static_cast<std::ptrdiff_t>(first + size)};
}

template<typename Scalar>
void check_all(std::uint32_t seed) {
    Random random(seed);
    for (std::size_t width = 2; width <= 13; ++width)
        for (const std::size_t dimension : {1, 2, 3, 4, 5, 8, 17, 1500}) {
            const Job<Scalar> job = random_job<Scalar>(width, dimension, random);
            const std::vector<Scalar> wanted = expected(job);
            for (const Isa isa : {Isa::Plain, Isa::Avx2, Isa::Best})
                for (const Way way : {Way::Cached, Way::Streamed, Way::Staged})
                    for (const std::size_t shift : {0, 1, 3}) {
                        if (way == Way::Staged && dimension * sizeof(Scalar) > staged_point_bytes) continue;
                        const auto points = computed(job, isa, way, shift, wanted.size());
                        ASSERT_EQ(std::memcmp(points.data(), wanted.data(), wanted.size() * sizeof(Scalar)), 0)
                            << "width " << width << ", dimension " << dimension << ", shift " << shift;
                    }
        }
}

TEST(Kernel, HasTheBytesOfThePlainSumInDoubles) {
    check_all<double>(1);
}

TEST(Kernel, HasTheBytesOfThePlainSumInFloats) {
    check_all<float>(2);
}

TEST(Kernel, IsPlainWhenForced) {
    EXPECT_EQ(usable(Isa::Plain), Isa::Plain);
    EXPECT_EQ(usable(Isa::Best), usable(Isa::Avx2));
}

TEST(Kernel, RefusesOtherWidths) {
    EXPECT_THROW((void)kernels<double>(Isa::Plain, 1, 3), std::invalid_argument);
    EXPECT_THROW((void)kernels<float>(Isa::Best, 14, 3), std::invalid_argument);
}

} // namespace
} // namespace internode
