// SPDX-License-Identifier: MIT

#include "internode/io/npy.h"

#include "internode/io/file/output_file.h"
#include "tests/fixtures/temporary_folder.h"

#include <cstring>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace internode {
namespace {

TEST(Npy, HasAHeaderOf64BytesMultipleAndLittleEndianDoubles) {
    const std::vector<double> coordinates{1, -0.0, 0.1, 5e-324, 1e300, 2};
    StringSink sink;
    EXPECT_TRUE(write_npy(sink, {3, coordinates}));
    const std::string& bytes = sink.text();
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
    EXPECT_EQ(header % 64, 0U);
    EXPECT_EQ(bytes[header - 1], '\n');
    EXPECT_NE(bytes.find("'shape': (2, 3)"), std::string::npos);
    ASSERT_EQ(bytes.size(), header + 8 * coordinates.size());
    EXPECT_EQ(bytes.substr(header, 8), std::string("\0\0\0\0\0\0\xF0\x3F", 8));
    EXPECT_EQ(bytes.substr(header + 8, 8), std::string("\0\0\0\0\0\0\0\x80", 8));
}

TEST(Npy, WritesManyPointsInChunks) {
    const std::vector<double> coordinates(100'001, 0.5);
    StringSink sink;
    EXPECT_TRUE(write_npy(sink, {1, coordinates}));
    EXPECT_EQ(sink.text().size() % 64, (8 * coordinates.size()) % 64);
    EXPECT_THROW(write_npy(sink, {2, coordinates}), std::invalid_argument);
}

TEST(Npy, IsWhatNumpyReads) {
    if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0)
        GTEST_SKIP() << "/usr/bin/python3 has no numpy: the files are not checked by their own reader";
    const tests::TemporaryFolder folder;
    const std::vector<double> coordinates{1, -0.0, 0.1, 5e-324, 1e300, 2};
    OutputFile file(folder / "a.npy");
    ASSERT_TRUE(write_npy(file, {2, coordinates}));
    ASSERT_FALSE(file.commit());
    const std::string check = "/usr/bin/python3 -c \"import numpy; a = numpy.load('" + (folder / "a.npy") +
                              "', allow_pickle=False); assert a.shape == (3, 2) and a.dtype == numpy.dtype('<f8') and "
                              "a.ravel().tolist() == [1, 0, 0.1, 5e-324, 1e300, 2] and numpy.signbit(a[0, 1])\"";
    EXPECT_EQ(std::system(check.c_str()), 0);
}

} // namespace
} // namespace internode
