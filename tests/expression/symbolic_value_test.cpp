// SPDX-License-Identifier: MIT

#include "internode/expression/symbolic_value.h"

#include "internode/grammar/points/parse_points.h"

#include <gmock/gmock.h>

#include <cmath>

namespace internode {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::Lt;
using testing::Pair;

/// Reads the only argument of the only rule's successor; numbers are the formals that begin with `s`.
struct Reading {
    explicit Reading(std::string_view text)
        : grammar(parse_point_grammar(text, "test").grammar.value())
        , constants(constants_of(grammar))
        , reader({grammar.definitions, constants}) {}

    static std::vector<KnownNumber> constants_of(const PointGrammar& grammar) {
        std::vector<KnownNumber> values(grammar.definitions.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            if (grammar.definitions[i].value.numbers.size() == 1)
                values[i].exact = grammar.definitions[i].value.numbers[0];
        return values;
    }

    std::optional<SymbolicValue> read(ConstantReading reading = ConstantReading::Symbols) {
        std::vector<Extent> extents;
        const PointRule& rule = grammar.rules.at(0);
        for (const std::string& formal : rule.formals) extents.push_back(formal.front() == 's' ? 0 : 2);
        return reader.read(rule.successor.at(0).arguments.at(0), extents, rule.formals, reading);
    }

    /// Of an argument that is a point: each formal with a coefficient, and the coefficient as text.
    std::vector<std::pair<std::size_t, std::string>> coefficients() {
        const std::optional<SymbolicValue> value = read();
        EXPECT_TRUE(value && value->is_point);
        std::vector<std::pair<std::size_t, std::string>> texts;
        if (value)
            for (const auto& [formal, coefficient] : value->coefficients)
                texts.emplace_back(formal, to_string(coefficient, reader.names()));
        return texts;
    }

    PointGrammar grammar;
    std::vector<KnownNumber> constants;
    SymbolicReader reader;
};

TEST(SymbolicValue, GivesTheCoefficientOfEachPoint) {
    Reading reading("points\nt = 1/3\nP(u, s) < P(v, s2) -> P((1 - t) u + s v - v, 0)");
    EXPECT_THAT(reading.coefficients(), ElementsAre(Pair(0, "1 - t"), Pair(2, "-1 + s")));
    EXPECT_FALSE(reading.read().value().has_coordinates);
}

TEST(SymbolicValue, AFactorMayFollowItsPoint) {
    Reading reading("points\nt = 1/3\nP(u) < P(v) -> P(u*t + v*(1 - t))");
    EXPECT_THAT(reading.coefficients(), ElementsAre(Pair(0, "t"), Pair(1, "1 - t")));
}

TEST(SymbolicValue, ConstantsMayBeTheirValues) {
    Reading reading("points\nt = 1/3\nP(u) < P(v) -> P(t u + v)");
    const auto value = reading.read(ConstantReading::Values);
    EXPECT_EQ(value.value().coefficients.at(0).second.constant(), Rational(1, 3));
}

TEST(SymbolicValue, FunctionsOfConstantsAreFolded) {
    Reading reading("points\nP(u, s) -> P((min(1/2, 3) + floor(7/2) + abs(-2) + sqrt(9/4)) u, 0)");
    EXPECT_EQ(reading.read().value().coefficients.at(0).second.constant(), Rational(7));
}

TEST(SymbolicValue, OthersAreVariablesNamedByTheirText) {
    Reading reading("points\nP(u, s, s2) -> P((max(s, s2) - max(s2, s) + sqrt(s)) u, 0, 0)");
    const auto value = reading.read();
    EXPECT_EQ(to_string(value.value().coefficients.at(0).second, reading.reader.names()), "sqrt(s)");
    // A sample gives the opaque variable the value that follows from the others.
    const auto variables = value->coefficients[0].second.variables();
    ASSERT_EQ(variables.size(), 1U);
    EXPECT_TRUE(reading.reader.is_opaque(variables[0]));
}

TEST(SymbolicValue, SamplesFollowTheFunctions) {
    Reading reading("points\nP(u, s) -> P((abs(s) abs(s) - s s) u, 0)");
    const auto value = reading.read();
    for (std::uint32_t sample = 0; sample < 6; ++sample)
        EXPECT_NEAR(value.value().coefficients.at(0).second.evaluate(reading.reader.sample(sample)), 0, 1e-12);
}

TEST(SymbolicValue, SamplesAreBelowOneAboveOneAndNegative) {
    std::string formals = "u";
    std::string sum = "0";
    std::string zeros;
    for (int i = 0; i < 20; ++i) {
        formals += ", s" + std::to_string(i);
        sum += " + s" + std::to_string(i);
        zeros += ", 0";
    }
    Reading reading("points\nP(" + formals + ") -> P((" + sum + ") u" + zeros + ")");
    ASSERT_TRUE(reading.read());
    ASSERT_EQ(reading.reader.names().size(), 20U);
    for (std::uint32_t sample = 0; sample < 9; sample += 3) {
        EXPECT_THAT(reading.reader.sample(sample), Each(AllOf(Gt(0), Lt(1))));
        EXPECT_THAT(reading.reader.sample(sample + 1), Each(Gt(1)));
        EXPECT_THAT(reading.reader.sample(sample + 2), Each(Lt(0)));
    }
    const double golden = (std::sqrt(5.0) - 1) / 2; // its first and 20th multiple
    EXPECT_DOUBLE_EQ(reading.reader.sample(0).front(), 0.4 + 0.5 * golden);
    EXPECT_NEAR(reading.reader.sample(0).back(), 0.4 + 0.5 * (20 * golden - std::floor(20 * golden)), 1e-13);
}

TEST(SymbolicValue, SaysWhyNothingIsDecided) {
    for (const char* text :
         {"points\nP(u, s) -> P(u / (s - s), 0)", "points\nP(u, s) -> P(u + s, 0)", "points\nP(u, s) -> P(u u, 0)",
          "points\nP(u, s) -> P(s / u, 0)", "points\nP(u, s) -> P(min(u, s) u, 0)"}) {
        Reading reading(text);
        EXPECT_FALSE(reading.read()) << text;
        EXPECT_FALSE(reading.reader.undecided().empty()) << text;
    }
}

TEST(SymbolicValue, ASumOfCoefficientsBeyondTheLimitsIsUndecided) {
    const std::string half_of_the_limit(symbolic_limits.coefficient / 5, '0'); // digits of more than three bits
    const auto text = [&](char last) {
        const std::string large = "1" + half_of_the_limit;
        return "points\nP(u, s) -> P((s / " + large + "0) u + (s / " + large + last + ") u, 0)";
    };
    EXPECT_TRUE(Reading(text('0')).read());
    Reading coprime(text('1'));
    EXPECT_FALSE(coprime.read());
    EXPECT_EQ(coprime.reader.undecided(), "its coefficients are larger than the check goes");
}

TEST(SymbolicValue, RemembersCoordinates) {
    EXPECT_TRUE(Reading("points\nP(u) -> P((1, 2))").read().value().has_coordinates);
    EXPECT_TRUE(Reading("points\nP(u) -> P(u.x u)").read().value().has_coordinates);
    EXPECT_TRUE(Reading("points\nP(u) -> P(u / u.y)").read().value().has_coordinates);
}

} // namespace
} // namespace internode
