// SPDX-License-Identifier: MIT

#include "internode/point/check/point_validation.h"

#include "internode/grammar/bundled.h"
#include "internode/grammar/points/parse_points.h"
#include "tests/fixtures/point_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

using tests::point_grammar;

PointValidation validation_of(std::string_view text) {
    return make_point_validation(point_grammar(text));
}

PointValidation bundled(std::string_view name) {
    return validation_of(find_bundled_grammar(name)->text);
}

TEST(PointValidation, RulesNamedAfterDynLevinAndMicchelliAreTheCubicSpline) {
    const PointValidation validation = validation_of(
        "points dyn_levin_micchelli\nring\nP(u) < P(v) > P(p) -> P(1/8 u + 6/8 v + 1/8 p) P(1/2 v + 1/2 p)\n");
    EXPECT_TRUE(validation.valid);
    ASSERT_TRUE(validation.mask);
    EXPECT_EQ(validation.mask->known.at(0).name, "uniform cubic B-spline");
    ASSERT_TRUE(validation.compilation->twin);
    EXPECT_EQ(validation.compilation->twin->degree, 3);
    EXPECT_EQ(validation.compilation->twin->moved, 0U);
}

TEST(PointValidation, TwinsOfThePapersSchemes) {
    struct Twin {
        const char* name;
        int degree;
        std::size_t moved;
    };
    // Equal in normal form, where a constant offset of the parents says nothing; or after moving one new point.
    for (const Twin& wanted : {Twin{"s0/18", 2, 0}, Twin{"s0/22", 3, 0}, Twin{"s0/13", 2, 1}, Twin{"s0/17", 2, 0},
                               Twin{"s0/20", 2, 0}, Twin{"s0/23", 3, 1}}) {
        const PointValidation validation = bundled(wanted.name);
        ASSERT_TRUE(validation.compilation && validation.compilation->twin) << wanted.name;
        EXPECT_EQ(validation.compilation->twin->degree, wanted.degree) << wanted.name;
        EXPECT_EQ(validation.compilation->twin->moved, wanted.moved) << wanted.name;
    }
    EXPECT_FALSE(bundled("s0/25").compilation->twin) << "no spline";
    EXPECT_FALSE(bundled("koch").compilation->twin);
}

TEST(PointValidation, LaneAndRiesenfeldOfEveryOrder) {
    const char* text = "points\nn = 2\nring\ntable p\nP(v) > P(u) -> P(v) P(1/2 v + 1/2 u)\n"
                       "table q\nP(v) > P(u) -> P(1/2 v + 1/2 u)\ncycle p q^n\n";
    for (int n = 0; n <= 6; ++n) {
        PointSettings settings;
        settings.constants["n"] = n;
        const PointValidation validation = make_point_validation(point_grammar(text), settings);
        ASSERT_TRUE(validation.mask) << n;
        EXPECT_EQ(validation.mask->properties.generation_degree, static_cast<std::size_t>(n) + 1);
        ASSERT_TRUE(validation.compilation->twin) << n;
        EXPECT_EQ(validation.compilation->twin->degree, n + 1);
        EXPECT_EQ(validation.mask->smoothness->holder_lower, n + 1.0);
    }
}

TEST(PointValidation, EveryBundledGrammarIsValid) {
    std::size_t count = 0;
    for (const BundledGrammar& grammar : bundled_grammars()) {
        if (kind_of(grammar.text) != GrammarKind::Points) continue;
        const PointValidation validation = validation_of(grammar.text);
        EXPECT_TRUE(validation.valid) << grammar.name;
        EXPECT_EQ(validation.compilation->compiles, validation.compilation->reasons.empty()) << grammar.name;
        ++count;
    }
    EXPECT_GE(count, 27U);
}

TEST(PointValidation, OneWrongSumIsNotValid) {
    const PointValidation validation =
        validation_of("points\nring\nP(u) < P(v) -> P(1/4 u + 3/4 v) P(1/4 u + 1/4 v)\n");
    EXPECT_FALSE(validation.valid);
    EXPECT_EQ(std::ranges::count(validation.affine, AffineVerdict::SumIsNotOne, &AffineFinding::verdict), 1);
    ASSERT_TRUE(validation.mask) << "what follows from the mask is said all the same";
    EXPECT_FALSE(validation.mask->properties.sums_are_one);
    EXPECT_EQ(validation.mask->smoothness->convergence, SchemeConvergence::Refuted);
}

TEST(PointValidation, IncompleteEndsAreNotValid) {
    EXPECT_FALSE(
        validation_of("points\nP(u) < P(v) > P(p) P(q) -> P(v) P(-1/16 u + 9/16 v + 9/16 p - 1/16 q)\n").valid);
}

TEST(PointValidation, MixedKindsAreProblems) {
    const PointValidation validation = validation_of("points\nring\nP(u) < P(v) -> P(u + 1)\n");
    EXPECT_FALSE(validation.valid);
    EXPECT_FALSE(validation.problems.empty());
    EXPECT_FALSE(validation.coverage);
    EXPECT_FALSE(validation.compilation);
}

TEST(PointValidation, CoordinatesSayHowManyThereAre) {
    const PointValidation validation =
        validation_of("points\nP(v) -> P(v)\ninterpretation\nP(v) -> Q((v.x / v.z, v.y / v.z))\n");
    EXPECT_EQ(validation.dimension, 3U);
    EXPECT_TRUE(validation.valid);
}

TEST(PointValidation, MasksAreRefusedAsMaskPropertiesRefusesThem) {
    EXPECT_THROW((void)mask_facts(UniformMask{}), std::invalid_argument);
}

} // namespace
} // namespace internode
