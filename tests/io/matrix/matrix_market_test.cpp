// SPDX-License-Identifier: MIT

#include "internode/io/matrix/matrix_market.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace internode {
namespace {

TEST(MatrixMarket, CountsFromOne) {
    const std::vector<MatrixEntry> entries{{0, 0, 0.25}, {2, 1, -1}};
    const std::vector<std::string> comments{"word SL", "a\n3 3 9\r\xE2\x80\xAE"};
    StringSink sink;
    EXPECT_TRUE(write_matrix_market(sink, {3, 2, entries}, comments));
    EXPECT_EQ(sink.text(), "%%MatrixMarket matrix coordinate real general\n% word SL\n% a?3 3 9??\n3 2 2\n"
                           "1 1 0.25\n3 2 -1\n");
}

TEST(MatrixMarket, CutsCommentsToTheLineLengthOfTheFormat) {
    StringSink sink;
    const std::vector<std::string> comments{std::string(5000, 'c')};
    EXPECT_TRUE(write_matrix_market(sink, {1, 1, {}}, comments));
    const std::size_t banner = sink.text().find('\n') + 1;
    EXPECT_LE(sink.text().find('\n', banner) - banner, 1024U);
}

TEST(MatrixMarket, RefusesEntriesOutsideAndNotFinite) {
    StringSink sink;
    for (const MatrixEntry& entry : {MatrixEntry{3, 0, 1}, MatrixEntry{0, 2, 1}}) {
        const std::vector<MatrixEntry> entries{entry};
        EXPECT_THROW(write_matrix_market(sink, {3, 2, entries}), std::out_of_range);
    }
    const std::vector<MatrixEntry> entries{{0, 0, std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_THROW(write_matrix_market(sink, {3, 2, entries}), std::invalid_argument);
}

} // namespace
} // namespace internode
