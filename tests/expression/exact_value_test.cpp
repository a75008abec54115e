// SPDX-License-Identifier: MIT

#include "internode/expression/exact_value.h"

#include "internode/expression/limits.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

/// The literal 1, negated so many times.
Expression negations(std::size_t count) {
    Expression expression;
    expression.numbers = {1};
    expression.code.assign(count + 1, {Operation::Negate, 0});
    expression.code.front() = {Operation::Number, 0};
    return expression;
}

TEST(ExactValue, TakesAsManyOperationsAsTheLimitAndNoMore) {
    const DefinitionScope scope;
    const ExactResult most = exact_value(negations(max_expression_operations - 1), {}, scope);
    ASSERT_TRUE(most.value) << most.reason;
    EXPECT_EQ(std::get<Rational>(*most.value), -1);
    const ExactResult more = exact_value(negations(max_expression_operations), {}, scope);
    EXPECT_FALSE(more.value);
    EXPECT_EQ(more.reason, "takes too many operations");
}

} // namespace
} // namespace internode
