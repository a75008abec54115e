// SPDX-License-Identifier: MIT

#include "internode/stencil/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace internode {
namespace {

constexpr int thread_counts[] = {1, 2, 3, 0};

std::string made(std::size_t i) {
    return std::to_string(i) + ";";
}

TEST(ForEachText, TakesAllTextsInTheirOrder) {
    for (const int threads : thread_counts)
        for (const std::size_t count : {0U, 1U, 2U, 7U, 500U}) {
            std::string expected;
            for (std::size_t i = 0; i < count; ++i) expected += made(i);
            std::string taken;
            EXPECT_TRUE(for_each_text(count, threads, made, [&](std::string_view text) {
                taken += text;
                return true;
            }));
            EXPECT_EQ(taken, expected) << threads << " threads";
        }
}

TEST(ForEachText, TakesNothingAfterARefusal) {
    for (const int threads : thread_counts) {
        std::string taken;
        std::atomic<std::size_t> count = 0;
        EXPECT_FALSE(for_each_text(
            1'000'000, threads,
            [&](std::size_t i) {
                ++count;
                return made(i);
            },
            [&](std::string_view text) {
                taken += text;
                return text != "3;";
            }));
        EXPECT_EQ(taken, "0;1;2;3;") << threads << " threads";
        EXPECT_LT(count, 100'000U) << "few are made ahead";
    }
}

TEST(ForEachText, ThrowsWhatIsThrown) {
    for (const int threads : thread_counts) {
        const auto bad = [](std::size_t i) { return i == 40 ? throw std::out_of_range("40") : made(i); };
        const auto good = [](std::string_view) { return true; };
        EXPECT_THROW((void)for_each_text(100, threads, bad, good), std::out_of_range);
        const auto refusing = [](std::string_view) -> bool { throw std::length_error("no place"); };
        EXPECT_THROW((void)for_each_text(100, threads, made, refusing), std::length_error);
    }
}

} // namespace
} // namespace internode
