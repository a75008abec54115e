// SPDX-License-Identifier: MIT

#include "internode/report/json/points_json.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/point/strands.h"
#include "tests/fixtures/point_systems.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::point_system;

std::string json_of(const PointStrands& strands, const PointSystem& system, const PointsDocument& document) {
    StringSink sink;
    EXPECT_TRUE(write_points_json(sink, strands, system, document));
    return sink.text();
}

PointStrands corner() {
    return {.dimension = 2, .points = {0, 0, 1, 2}, .strands = {{.points = {0, 1}, .closed = true}}, .lines = {}};
}

TEST(PointsJson, TellsConstantsExactlyWhereTheyAre) {
    const PointSystem system = point_system("points g\nt = 1/4\nh = sqrt(2)\nf(x) = x\nring\nP(v) -> P(v)\n");
    EXPECT_THAT(json_of(corner(), system, {.name = "g", .cycles = 3, .generator = {}}),
                AllOf(HasSubstr("\"t\": {\"value\": 0.25, \"exact\": \"1/4\"}"),
                      HasSubstr("\"h\": {\"value\": 1.4142135623730951, \"exact\": null}"), Not(HasSubstr("\"f\"")),
                      HasSubstr("\"cycles\": 3"), HasSubstr("\"closed\": true"), HasSubstr("[1, 2]")));
}

TEST(PointsJson, SetsWeightsApart) {
    const PointSystem system = point_system("points g\nring\nP(v) -> P(v)\n");
    const std::string text = json_of(corner(), system, {.name = "g", .weighted = true, .generator = {}});
    EXPECT_THAT(text, HasSubstr("\"weights\": [0, 2]"));
    EXPECT_THAT(text, AllOf(HasSubstr("[0]"), HasSubstr("[1]")));
    PointStrands numbers = corner();
    numbers.dimension = 1;
    StringSink sink;
    EXPECT_THROW(write_points_json(sink, numbers, system, {.name = "g", .weighted = true, .generator = {}}),
                 std::invalid_argument);
}

TEST(PointsJson, WritesLinesAsPairs) {
    const PointSystem system = point_system("points g\nring\nP(v) -> P(v)\n");
    PointStrands strands = corner();
    strands.lines = {0, 0, 1, 2};
    EXPECT_THAT(json_of(strands, system, {.name = "g", .generator = {}}), HasSubstr("[[0, 0], [1, 2]]"));
}

TEST(PointsJson, RefusesWhatJsonHasNot) {
    const PointSystem system = point_system("points g\nring\nP(v) -> P(v)\n");
    PointStrands strands = corner();
    strands.points[3] = std::numeric_limits<double>::quiet_NaN();
    StringSink sink;
    EXPECT_THROW(write_points_json(sink, strands, system, {.name = "g", .generator = {}}), std::invalid_argument);
}

TEST(PointsJson, HasAWholeDocumentForEachPartOfSeveral) {
    const PointSystem system = point_system("points g\nring\nP(v) -> P(v)\n");
    const PointStrands strands = corner();
    const std::vector<PointsPart> parts{{strands, system, {.name = "g", .cycles = 2, .generator = {"0", "x"}}},
                                        {strands, system, {.name = "g", .weighted = true, .generator = {"0", "x"}}}};
    StringSink sink;
    EXPECT_TRUE(write_parts_json(sink, parts));
    const std::string text = sink.text();
    EXPECT_THAT(text, HasSubstr("\"format\": \"internode-parts\",\n  \"version\": 1"));
    const auto flat = [](std::string all) {
        std::erase_if(all, [](char c) { return c == ' ' || c == '\n'; });
        return all;
    };
    for (const PointsPart& part : parts)
        EXPECT_THAT(flat(text), HasSubstr(flat(json_of(part.strands, part.system, part.document))));
    PointStrands numbers = corner();
    numbers.dimension = 1;
    const std::vector<PointsPart> bad{{numbers, system, {.name = "g", .weighted = true, .generator = {}}}};
    StringSink none;
    EXPECT_THROW(write_parts_json(none, bad), std::invalid_argument);
    EXPECT_EQ(none.text(), "");
}

} // namespace
} // namespace internode
