// SPDX-License-Identifier: MIT

#include "internode/stencil/line_writer.h"

#include "tests/fixtures/stride.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace internode {
namespace {

/// 1, 2, … `count` written from place `shift` of a line on, `piece` of them at a time, among zeros.
template<typename Scalar>
std::vector<Scalar> written(std::size_t shift, std::size_t count, std::size_t piece, std::size_t& start) {
    constexpr std::size_t line = LineWriter<Scalar>::line;
    std::vector<Scalar> memory(count + 4 * line);
    const std::size_t place = reinterpret_cast<std::uintptr_t>(memory.data()) / sizeof(Scalar) % line;
    start = line - place + shift;
    LineStage<Scalar> stage;
    LineWriter<Scalar> writer(stage, memory.data() + start);
    for (std::size_t done = 0; done < count;) {
        const std::size_t part = std::min(piece, count - done);
        Scalar* const next = writer.next(part);
        std::iota(next, next + part, static_cast<Scalar>(done + 1));
        writer.wrote(part);
        done += part;
    }
    writer.finish();
    return memory;
}

template<typename Scalar>
void expect_runs_of_any_place_and_length() {
    constexpr std::size_t line = LineWriter<Scalar>::line;
    tests::Compared compared;
    std::vector<std::size_t> counts(4 * line + 1);
    std::iota(counts.begin(), counts.end(), std::size_t{0});
    const std::size_t full = LineWriter<Scalar>::capacity;
    counts.insert(counts.end(), {full - line, full - 1, full, full + 1, 3 * full + 5});
    for (std::size_t shift = 0; shift < line; ++shift)
        for (const std::size_t count : counts)
            for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, line, full - line}) {
                std::size_t start = 0;
                const std::vector<Scalar> memory = written<Scalar>(shift, count, piece, start);
                std::vector<Scalar> expected(memory.size());
                std::iota(expected.begin() + static_cast<std::ptrdiff_t>(start),
                          expected.begin() + static_cast<std::ptrdiff_t>(start + count), Scalar{1});
                ASSERT_EQ(memory, expected) << "from " << shift << ", " << count << " by " << piece;
                ++compared;
            }
}

} // namespace

TEST(LineWriter, WritesARunOfAnyPlaceAndLengthAndNothingBesideIt) {
    expect_runs_of_any_place_and_length<double>();
    expect_runs_of_any_place_and_length<float>();
}

} // namespace internode
