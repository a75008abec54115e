// SPDX-License-Identifier: MIT

#include "internode/stencil/step_matrix.h"

#include "tests/fixtures/interval_systems.h"
#include "tests/reference/step_matrix.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

using tests::system_of;
using tests::word_of;

/// Degree, word and ends of a few steps: closed, short enough to wrap, open, clamped, with a double knot.
struct Steps {
    int degree;
    const char* word;
    Ends ends;
};
constexpr Steps few_steps[] = {
    {1, "LS", Ends::Circular},  {2, "LSL", Ends::Circular},    {3, "L", Ends::Circular},  {3, "LSLSLLS", Ends::Open},
    {2, "00LSL00", Ends::Open}, {3, "LSLL0LSLSL", Ends::Open}, {4, "SL", Ends::Circular}, {3, "L0LLS", Ends::Circular},
};

TEST(StepMatrix, EqualsTheMasksAndKnotInsertion) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (const Steps& steps : few_steps) {
        const Word word = word_of(fibonacci, steps.word);
        const StepMatrix matrix = step_matrix(fibonacci, steps.degree, word, steps.ends);
        reference::Matrix dense = reference::zero_matrix(matrix.rows, matrix.columns);
        for (const StepMatrix::Entry& entry : matrix.entries) dense[entry.row][entry.column] = entry.weight;
        EXPECT_EQ(dense, reference::scatter_matrix(fibonacci, word, steps.degree, steps.ends)) << steps.word;
        EXPECT_EQ(dense, reference::boehm_matrix(fibonacci, word, steps.degree, steps.ends)) << steps.word;
    }
}

TEST(StepMatrix, HasItsEntriesByRowThenColumnAndNoZeros) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (const Steps& steps : few_steps) {
        const StepMatrix matrix = step_matrix(fibonacci, steps.degree, word_of(fibonacci, steps.word), steps.ends);
        for (std::size_t i = 0; i < matrix.entries.size(); ++i) {
            EXPECT_GT(matrix.entries[i].weight.sign(), 0);
            if (i == 0) continue;
            const auto place = [&](std::size_t at) {
                return std::pair(matrix.entries[at].row, matrix.entries[at].column);
            };
            EXPECT_LT(place(i - 1), place(i));
        }
    }
}

TEST(StepMatrix, AsASparseMatrixHoldsTheNearestDoubles) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (const Steps& steps : few_steps) {
        const StepMatrix matrix = step_matrix(fibonacci, steps.degree, word_of(fibonacci, steps.word), steps.ends);
        const auto rounded = sparse(matrix);
        ASSERT_EQ(static_cast<std::uint64_t>(rounded.rows()), matrix.rows);
        ASSERT_EQ(static_cast<std::uint64_t>(rounded.cols()), matrix.columns);
        ASSERT_EQ(static_cast<std::size_t>(rounded.nonZeros()), matrix.entries.size());
        for (const StepMatrix::Entry& entry : matrix.entries)
            EXPECT_EQ(rounded.coeff(static_cast<int>(entry.row), static_cast<int>(entry.column)),
                      entry.weight.to_double());
    }
}

} // namespace
} // namespace internode
