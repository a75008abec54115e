// SPDX-License-Identifier: MIT

#include "internode/expression/expression.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

TEST(SourcePlace, IsComparedByWhatItSays) {
    EXPECT_EQ((SourcePlace{3, 2}), (SourcePlace{3, 2}));
    EXPECT_NE((SourcePlace{3, 2}), (SourcePlace{4, 2}));
    EXPECT_NE((SourcePlace{3, 2}), (SourcePlace{3, 1}));
}

TEST(SourcePlace, IsNoPartOfTheExpressionThatStandsThere) {
    Expression here;
    here.numbers = {Rational(1)};
    Expression there = here;
    there.place = SourcePlace{7, 1};
    EXPECT_EQ(here, there);
    there.numbers = {Rational(2)};
    EXPECT_NE(here, there);
}

} // namespace
} // namespace internode
