// SPDX-License-Identifier: MIT

#include "internode/stencil/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

namespace internode {
namespace {

constexpr int thread_counts[] = {1, 2, 3, 0};

std::string made(std::size_t i) {
    return std::to_string(i) + ";";
}

/// Makes texts of which number `late` is not ready before two after it are, where there are threads to make them.
class LateText {
public:
    explicit LateText(std::size_t late)
        : late_(late) {}

    std::string operator()(std::size_t i) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
        while (i == late_ && after_ < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        if (i > late_) ++after_;
        return made(i);
    }

private:
    std::size_t late_;
    std::atomic<int> after_ = 0;
};

TEST(ForEachText, TakesALateTextBeforeThoseThatAreReady) {
    for (const int threads : thread_counts) {
        LateText late(2);
        std::string taken;
        EXPECT_TRUE(for_each_text(6, threads, std::ref(late), [&](std::string_view text) {
            taken += text;
            return true;
        }));
        EXPECT_EQ(taken, "0;1;2;3;4;5;") << threads << " threads";
    }
}

TEST(ForEachText, TakesNothingThatIsReadyWhenAnEarlierOneIsRefused) {
    for (const int threads : thread_counts) {
        LateText late(3);
        std::string taken;
        EXPECT_FALSE(for_each_text(100, threads, std::ref(late), [&](std::string_view text) {
            taken += text;
            return text != "3;";
        }));
        EXPECT_EQ(taken, "0;1;2;3;") << threads << " threads";
    }
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
