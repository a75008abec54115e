// SPDX-License-Identifier: MIT

#include "internode/point/point_system.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::HasSubstr;

/// `a u + b v` of the formals first and second.
Expression sum_of_two(const Rational& a, std::uint32_t first, const Rational& b, std::uint32_t second) {
    return {{{Operation::Number, 0},
             {Operation::Formal, first},
             {Operation::Multiply, 0},
             {Operation::Number, 1},
             {Operation::Formal, second},
             {Operation::Multiply, 0},
             {Operation::Add, 0}},
            {a, b},
            {}};
}

/// S0 (13).
PointGrammar chaikin() {
    PointGrammar grammar;
    grammar.ring = true;
    const Symbol point = grammar.letters.add("P");
    grammar.arity = {1};
    PointRule& rule = grammar.rules.emplace_back();
    rule.left = rule.predecessor = rule.right = {point};
    rule.formals = {"u", "v", "w"};
    rule.successor = {{point, {sum_of_two({1, 4}, 0, {3, 4}, 1)}, {}}, {point, {sum_of_two({3, 4}, 1, {1, 4}, 2)}, {}}};
    return grammar;
}

TEST(PointSystem, KnowsThatPointsStayPoints) {
    const CheckedPointSystem made = make_point_system(chaikin(), {.dimension = 3});
    ASSERT_TRUE(made.system);
    const Layout expected{std::vector<Extent>{3}};
    EXPECT_EQ(made.system->layout(), expected);
    EXPECT_EQ(made.system->cycle().size(), 1U);
    EXPECT_EQ(made.system->rules_of(std::nullopt).size(), 1U);
}

TEST(PointSystem, RefusesASumOfANumberAndAPoint) {
    PointGrammar grammar = chaikin();
    grammar.rules[0].successor[0].arguments[0].code[2].operation = Operation::Add;
    const CheckedPointSystem made = make_point_system(std::move(grammar));
    ASSERT_EQ(made.problems.size(), 1U);
    EXPECT_THAT(made.problems[0].message, HasSubstr("a number and a point of 2 coordinates (`u`) cannot be added"));
}

} // namespace
} // namespace internode
