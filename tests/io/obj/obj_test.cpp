// SPDX-License-Identifier: MIT

#include "internode/io/obj/obj.h"

#include <sstream>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace internode {
namespace {

std::string obj(std::size_t dimension, const std::vector<double>& coordinates, Ends ends,
                const std::vector<std::string>& comments = {}) {
    StringSink sink;
    EXPECT_TRUE(write_obj(sink, {dimension, coordinates}, ends, comments));
    return sink.text();
}

TEST(Obj, PadsCoordinatesWithZero) {
    EXPECT_EQ(obj(1, {0.5, 2}, Ends::Open), "v 0.5 0 0\nv 2 0 0\nl 1 2\n");
    EXPECT_EQ(obj(2, {1, 2}, Ends::Open), "v 1 2 0\np 1\n");
    EXPECT_EQ(obj(3, {1, 2, 3}, Ends::Circular), "v 1 2 3\np 1\n");
    EXPECT_EQ(obj(3, {}, Ends::Circular), "");
}

TEST(Obj, ClosesACircularPolygon) {
    EXPECT_EQ(obj(1, {1, 2, 3}, Ends::Circular), "v 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2 3 1\n");
}

TEST(Obj, ChainsLinesThroughAllPointsOnce) {
    for (const std::size_t size : {2U, 3U, 255U, 256U, 257U, 510U, 511U, 512U, 5000U})
        for (const Ends ends : {Ends::Open, Ends::Circular}) {
            std::istringstream lines(obj(1, std::vector<double>(size, 0.5), ends));
            std::vector<std::size_t> path;
            for (std::string line; std::getline(lines, line);) {
                if (!line.starts_with("l ")) continue;
                std::istringstream indices(line.substr(2));
                std::vector<std::size_t> part;
                for (std::size_t index = 0; indices >> index;) part.push_back(index);
                ASSERT_GE(part.size(), 2U);
                ASSERT_LE(part.size(), 256U);
                if (!path.empty()) {
                    ASSERT_EQ(part.front(), path.back());
                }
                path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
            }
            ASSERT_EQ(path.size(), size + (ends == Ends::Circular ? 1 : 0)) << size;
            for (std::size_t i = 0; i < path.size(); ++i) ASSERT_EQ(path[i], i % size + 1);
        }
}

TEST(Obj, KeepsHostileCommentsOnTheirLine) {
    EXPECT_EQ(obj(1, {1}, Ends::Open, {"a\nv 9 9 9\x1b[2J\xFF φ"}), "# a?v 9 9 9?[2J? φ\nv 1 0 0\np 1\n");
}

TEST(Obj, RefusesFourDimensionsAndBrokenRows) {
    StringSink sink;
    const std::vector<double> four{1, 2, 3, 4};
    EXPECT_THROW(write_obj(sink, {4, four}, Ends::Open), std::invalid_argument);
    EXPECT_THROW(write_obj(sink, {3, four}, Ends::Open), std::invalid_argument);
}

TEST(Obj, WritesSeveralPolylines) {
    const std::vector<double> points{0, 1, 2, 3};
    const std::vector<ObjPolyline> polylines{{{0, 1, 2}, true}, {{1, 3}, false}, {{3}, false}};
    StringSink sink;
    EXPECT_TRUE(write_obj(sink, {1, points}, polylines));
    EXPECT_EQ(sink.text(), "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2 3 1\nl 2 4\np 4\n");
    EXPECT_THROW(write_obj(sink, {1, points}, std::vector<ObjPolyline>{{{4}, false}}), std::out_of_range);
}

TEST(Obj, CountsFromTheVerticesThatStandBefore) {
    const std::vector<double> points{0, 1, 2};
    StringSink sink;
    EXPECT_TRUE(write_obj(sink, {1, points}, std::vector<ObjPolyline>{{{0, 2}, false}, {{1, 2, 0}, true}}, {}, 7));
    EXPECT_EQ(sink.text(), "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 8 10\nl 9 10 8 9\n");
    EXPECT_THROW(write_obj(sink, {1, points}, std::vector<ObjPolyline>{{{3}, false}}, {}, 7), std::out_of_range);
}

} // namespace
} // namespace internode
