// SPDX-License-Identifier: MIT

#include "internode/stencil/coordinate_buffer.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace internode {
namespace {

/// Below, at and around the sizes from which large pages are asked for, and memory that ends within one.
const std::size_t sizes[] = {0, 1, 7, 262143, 262144, 524287, 524288, 524289, 1000003};

TEST(CoordinateBuffer, HoldsWhatIsWrittenToIt) {
    for (const std::size_t size : sizes) {
        CoordinateBuffer<double> buffer(size);
        ASSERT_EQ(buffer.values().size(), size);
        std::ranges::fill(buffer.values(), 2.5);
        EXPECT_EQ(std::ranges::count(buffer.values(), 2.5), static_cast<std::ptrdiff_t>(size));
    }
}

TEST(InLargePages, AreZerosOfTheSizeAskedFor) {
    for (const std::size_t size : sizes) {
        std::vector<double> values = in_large_pages<double>(size);
        ASSERT_EQ(values.size(), size);
        EXPECT_EQ(std::ranges::count(values, 0.0), static_cast<std::ptrdiff_t>(size));
        std::ranges::fill(values, 1.0);
        values.resize(size + 1); // moved: it is the allocator's memory like any other
        EXPECT_EQ(std::ranges::count(values, 1.0), static_cast<std::ptrdiff_t>(size));
    }
}

} // namespace
} // namespace internode
