// SPDX-License-Identifier: MIT
//
// A pyramid of a file, believed: lengths that are positive, an origin that goes with it, and refusals with their place.

#include "internode/input/settled_pyramid.h"

#include "internode/curve/parameter.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"
#include "tests/input/refusals.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string leaf() {
    return content(in_source_folder("data/pyramids/leaf.json"));
}

Settled<Pyramid> settle_text(const std::string& text) {
    const ParsedPyramid parsed = read_pyramid(text, "p.json");
    EXPECT_TRUE(parsed.pyramid) << to_string(parsed.errors);
    return settle_pyramid(parsed.pyramid.value());
}

TEST(SettledPyramid, RefusesLengthsThatAreNotPositiveAtTheirPlace) {
    for (const char* const bad : {R"("exact": ["0", "0"])", R"("exact": ["-1", "0"])", R"("exact": ["3", "-2"])"})
        EXPECT_THAT(refusal_of(settle_text(changed(leaf(), R"("exact": ["1", "0"])", bad))),
                    AllOf(testing::ContainsRegex("p.json:[0-9]+:[0-9]+: error"), HasSubstr("must be positive")))
            << bad;
}

TEST(SettledPyramid, BeginsWhereItsFileSays) {
    const std::string with_origin =
        changed(leaf(), "\"method\":", R"("origin": {"value": 5, "exact": ["5", "0"]}, "method":)");
    const Settled<Pyramid> pyramid = settle_text(with_origin);
    ASSERT_TRUE(pyramid.value) << refusal_of(pyramid);
    EXPECT_EQ(knot_positions(pyramid.value->coarse).front(), 5);
    EXPECT_EQ(knot_positions(settle_text(leaf()).value.value().coarse).front(), 0);
    EXPECT_THAT(refusal_of(settle_text(changed(with_origin, R"(["5", "0"])", R"(["5", "0", "1"])"))),
                HasSubstr("\"origin\" has 3 coefficients"));
}

TEST(SettledPyramid, RefusesWhatDoesNotFitTogether) {
    EXPECT_EQ(refusal_of(settle_text(leaf())), "none");
    for (const char* const name : {"", "0", "a b", "\u00e9"})
        EXPECT_THAT(refusal_of(settle_text(changed(leaf(), "\"S\": [\"L\"]", '"' + std::string(name) + "\": [\"L\"]"))),
                    HasSubstr("is no name of a symbol"))
            << name;
    EXPECT_THAT(refusal_of(settle_text(changed(leaf(), "\"S\": [\"L\"]", "\"S\": [\"S\"]"))), HasSubstr("not valid"));
    EXPECT_THAT(refusal_of(settle_text(changed(leaf(), "\"word\": [\"L\"", "\"word\": [\"Q\""))), HasSubstr("`Q`"));
    EXPECT_THAT(refusal_of(settle_text(changed(leaf(), "\"word\": [\"L\"", "\"word\": [\"S\""))), HasSubstr("level 1"));
}

} // namespace
} // namespace internode::tests
