// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace internode {
namespace {

TEST(CellArray, TakesAsFewBytesAsTheLastStateNeeds) {
    for (const auto& [count, bytes] : std::vector<std::pair<std::uint32_t, std::size_t>>{
             {1, 1}, {0x100, 1}, {0x101, 2}, {0x10000, 2}, {0x10001, 4}}) {
        EXPECT_EQ(CellArray::bytes_for(count), bytes) << count;
        const CellArray cells({0, count - 1}, count);
        EXPECT_EQ(cells.bytes_per_cell(), bytes) << count;
        EXPECT_EQ(cells.visit([](const auto* states) { return std::uint32_t{states[1]}; }), count - 1);
    }
}

} // namespace
} // namespace internode
