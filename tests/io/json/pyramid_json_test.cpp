// SPDX-License-Identifier: MIT
//
// Pyramids as files: what pyramid_json writes is read back bit for bit, and damage is met with a place or a sentence.

#include "internode/io/json/pyramid_json.h"

#include "internode/curve/refinement.h"
#include "internode/input/settled_pyramid.h"
#include "internode/report/json/pyramid_json.h"
#include "internode/report/pyramid_report.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::HasSubstr;
using tests::changed;
using tests::Random;
using tests::random_curve;
using tests::Shape;
using tests::system_of;

const std::size_t stride = tests::stride();

std::string leaf() {
    return tests::content(tests::in_source_folder("data/pyramids/leaf.json"));
}

/// What is said about a text that is no pyramid.
std::string pyramid_refusal(const std::string& text) {
    const ParsedPyramid parsed = read_pyramid(text, "p.json");
    EXPECT_EQ(parsed.pyramid.has_value(), parsed.errors.empty());
    if (!parsed.pyramid) return to_string(parsed.errors);
    const Settled<Pyramid> settled = settle_pyramid(*parsed.pyramid);
    EXPECT_EQ(settled.value.has_value(), settled.refusal.errors.empty());
    return settled.value ? "none" : to_string(settled.refusal.errors);
}

TEST(PyramidJson, IsReadBackBitForBit) {
    Random random(1);
    for (const char* const rules : {"L->SL, S->L", "A->AA, B->BB", "A->DD, B->A, C->B, D->C"})
        for (const Shape shape : {Shape::Closed, Shape::Clamped, Shape::ClampedWithZeros})
            for (const ReverseMethod method : {ReverseMethod::LeastSquares, ReverseMethod::Local}) {
                const Curve coarse = random_curve(random, system_of(rules), 3, shape, 6, 3);
                std::vector<double> fine(refined_size(coarse, 3, 100'000).points * 3);
                for (double& number : fine) number = random.coordinate();
                Analysis analysis = analyse(coarse.knots(), 3, 3, fine, {method, 4});
                Pyramid kept = with_longest(analysis.pyramid, 7);
                const std::vector<std::vector<double>> polygons = synthesise(kept);
                const PyramidReport report = pyramid_report(std::move(analysis), std::move(kept), {}, "x.csv");
                const ParsedPyramid parsed = read_pyramid(pyramid_json(report, {"0", "internode"}), "p.json");
                ASSERT_TRUE(parsed.pyramid) << to_string(parsed.errors);
                const Settled<Pyramid> settled = settle_pyramid(*parsed.pyramid);
                ASSERT_TRUE(settled.value) << to_string(settled.refusal.errors);
                EXPECT_EQ(synthesise(*settled.value), polygons);
            }
}

TEST(PyramidJson, KeepsTheAxiomAndTheLengthsOfItsGrammar) {
    const IntervalSystem system = system_of("A->AA, B->BB, length B = 3/7, axiom (A A B)");
    const Knots knots = *make_knots(system, {2, Ends::Circular, tests::word_of(system, "AAB")}).knots;
    const std::vector<double> fine{0, 1, 5, 2, 7, 3};
    Analysis analysis = analyse(knots, 1, 1, fine);
    Pyramid kept = analysis.pyramid;
    const PyramidReport report = pyramid_report(std::move(analysis), std::move(kept), {}, "x.csv");
    const ParsedPyramid parsed = read_pyramid(pyramid_json(report, {"0", "internode"}), "p.json");
    const Settled<Pyramid> settled = settle_pyramid(*parsed.pyramid);
    ASSERT_TRUE(settled.value);
    const IntervalSystem& again = settled.value->coarse.system();
    EXPECT_EQ(again.lengths()[1] / again.lengths()[0], system.lengths()[1] / system.lengths()[0]);
    EXPECT_EQ(again.grammar().axiom, system.grammar().axiom);
}

TEST(PyramidJson, RefusesWhatIsNoPyramidWithItsPlace) {
    const std::string text = leaf();
    ASSERT_EQ(pyramid_refusal(text), "none");
    EXPECT_THAT(pyramid_refusal("[]"), HasSubstr("p.json:1:1"));
    EXPECT_THAT(pyramid_refusal(changed(text, "internode-pyramid", "internode-curve")), HasSubstr("p.json:2:13"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"version\": 1", "\"version\": 2")), HasSubstr("`version` must be 1"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"degree\": 3", "\"degree\": 13")), HasSubstr("0 to 12"));
    EXPECT_THAT(pyramid_refusal(changed(text, "least-squares", "magic")), HasSubstr("`method`"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"levels\"", "\"layers\"")), HasSubstr("`levels` is missing"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"at\": [", "\"at\": [-1, ")), HasSubstr("a point of `at`"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"details\": [", "\"details\": [[1], ")), HasSubstr("1 coordinates"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"closed\": true", "\"closed\": 1")), HasSubstr("true or false"));
}

TEST(PyramidJson, RefusesWhatDoesNotFitTogether) {
    const std::string text = leaf();
    EXPECT_THAT(pyramid_refusal(changed(text, "\"degree\": 3", "\"degree\": 0")), HasSubstr("between 1 and 12"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"L\": [\"S\", \"L\"]", "\"L\": [\"S\", \"X\"]")), HasSubstr("`X`"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"S\": [\"L\"]", "\"S\": [\"S\"]")), HasSubstr("not valid"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"S\": [\"L\"]", "\"S\": []")), HasSubstr("no rule"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"S\": [\"L\"]", "\"S\": [\"0\"]")), HasSubstr("no rule"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"word\": [\"L\"", "\"word\": [\"Q\"")), HasSubstr("`Q`"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"word\": [\"L\"", "\"word\": [\"L\", \"L\"")), HasSubstr("letter"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"word\": [\"L\"", "\"word\": [\"S\"")), HasSubstr("level 1"));
    EXPECT_THAT(pyramid_refusal(changed(text, "\"exact\": [\"1\", \"0\"]", "\"exact\": [\"2\", \"0\"]")),
                HasSubstr("length"));
}

TEST(PyramidJson, AnswersClearlyForEveryPrefixAndEveryDamagedByte) {
    const std::string text = leaf();
    for (std::size_t i = 0; i + 1 < text.size(); i += stride) EXPECT_NE(pyramid_refusal(text.substr(0, i)), "");
    for (std::size_t i = 0; i < text.size(); i += 3 * stride)
        for (const char byte : {'\0', '\xff', '\n', '"'}) {
            std::string damaged = text;
            damaged[i] = byte;
            EXPECT_NE(pyramid_refusal(damaged), "");
        }
}

} // namespace
} // namespace internode
