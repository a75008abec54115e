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
    std::vector<Scalar> parents;                ///< cell i starts at parent i; nothing behind the padding
    std::vector<std::vector<Scalar>> weights{}; ///< per cell, width a row
};

template<typename Scalar>
Job<Scalar> random_job(std::size_t width, std::size_t dimension, Random& random) {
    Job<Scalar> job{width, dimension, {1, 2, 1, 40, 3, 7, 8}, {}};
    if (dimension < 100) job.rows.insert(job.rows.begin() + 2, 4096 / dimension + 21); // more than a stage has
    job.parents.resize((job.rows.size() - 1 + width) * dimension + padding_bytes / sizeof(Scalar));
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

/// As many groups in each cell as there can be, one less, or none.
enum class Groups { All, Fewer, None };

/// The cell's weights with the first `groups` groups of `group` rows as CellWork has them.
template<typename Scalar>
std::vector<Scalar> grouped(const std::vector<Scalar>& weights, std::size_t width, std::size_t groups,
                            std::size_t group) {
    std::vector<Scalar> result = weights;
    for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t r = 0; r < group; ++r)
            for (std::size_t k = 0; k < width; ++k)
                result[(g * width + k) * group + r] = weights[(g * group + r) * width + k];
    return result;
}

/// How a job is done.
struct Manner {
    Isa isa;
    Way way;
    Groups groups;
    std::size_t shift; ///< scalars between a cache line and the first point
};

/// The kernel's points, written between guards that must survive.
template<typename Scalar>
std::vector<Scalar> computed(const Job<Scalar>& job, const Manner& manner, std::size_t size) {
    const auto [isa, way, groups, shift] = manner;
    constexpr std::size_t guard = 16;
    const Scalar untouched(7);
    std::vector<Scalar> memory(size + 3 * guard + shift, untouched);
    const std::size_t misplaced = reinterpret_cast<std::uintptr_t>(memory.data()) / sizeof(Scalar) % guard;
    const std::size_t first = 2 * guard - misplaced + shift;
    const Kernels<Scalar> chosen = kernels<Scalar>(isa, job.width, job.dimension);
    std::vector<CellWork<Scalar>> work;
    std::vector<std::vector<Scalar>> weights;
    for (std::size_t cell = 0; cell < job.rows.size(); ++cell) {
        std::size_t count = chosen.group == 1 || groups == Groups::None ? 0 : job.rows[cell] / chosen.group;
        if (groups == Groups::Fewer && count > 0) --count;
        weights.push_back(grouped(job.weights[cell], job.width, count, chosen.group));
        work.push_back({job.parents.data() + cell * job.dimension, weights.back().data(), job.rows[cell], count});
    }
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
void check(const Job<Scalar>& job, const std::vector<Scalar>& wanted, const Manner& manner) {
    if (manner.way == Way::Staged && job.dimension * sizeof(Scalar) > staged_point_bytes) return;
    const auto points = computed(job, manner, wanted.size());
    ASSERT_EQ(std::memcmp(points.data(), wanted.data(), wanted.size() * sizeof(Scalar)), 0)
        << "width " << job.width << ", dimension " << job.dimension << ", shift " << manner.shift << ", way "
        << static_cast<int>(manner.way) << ", groups " << static_cast<int>(manner.groups);
}

/// Every width and way, at every place that a scalar can have in a cache line where points are short.
template<typename Scalar>
void check_all(std::uint32_t seed) {
    Random random(seed);
    for (std::size_t width = 2; width <= 13; ++width)
        for (const std::size_t dimension : {1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 17, 70, 1500, 4500}) {
            const Job<Scalar> job = random_job<Scalar>(width, dimension, random);
            const std::vector<Scalar> wanted = expected(job);
            const std::size_t shifts = (width == 4 || width == 13) && dimension < 10 ? 64 / sizeof(Scalar) : 2;
            for (const Isa isa : {Isa::Plain, Isa::Avx2, Isa::Best})
                for (const Way way : {Way::Cached, Way::Streamed, Way::Staged})
                    for (const Groups groups : {Groups::All, Groups::Fewer, Groups::None})
                        for (std::size_t shift = 0; shift < (groups == Groups::Fewer ? 2 : shifts); ++shift)
                            check(job, wanted, {isa, way, groups, shift});
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
