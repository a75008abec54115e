// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_mask.h"

#include "internode/interval/validity.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace internode {
namespace {

IntervalSystem splits_into(std::size_t letters) {
    IntervalGrammar grammar;
    const Symbol symbol = grammar.alphabet.add("A");
    grammar.rules = Morphism({Word(letters, symbol)});
    return validate(grammar).system.value();
}

/// m ((1 + … + z^(m-1)) / m)^(d+1), by repeated convolution.
std::vector<Rational> b_spline_mask(std::size_t m, int degree) {
    std::vector<Rational> mask{Rational(static_cast<unsigned long>(m))};
    for (int factor = 0; factor <= degree; ++factor) {
        std::vector<Rational> next(mask.size() + m - 1);
        for (std::size_t i = 0; i < mask.size(); ++i)
            for (std::size_t k = 0; k < m; ++k) next[i + k] += mask[i] / Rational(static_cast<unsigned long>(m));
        mask = std::move(next);
    }
    return mask;
}

TEST(CellMask, OfOneSymbolIsThatOfTheUniformBSpline) {
    for (std::size_t m = 2; m <= 4; ++m)
        for (int degree = 1; degree <= 5; ++degree) {
            const std::optional<UniformMask> mask = uniform_mask(splits_into(m), degree);
            ASSERT_TRUE(mask);
            EXPECT_EQ(mask->arity, m);
            EXPECT_EQ(mask->coefficients, b_spline_mask(m, degree)) << m << ' ' << degree;
        }
}

TEST(CellMask, IsNoneForSeveralSymbols) {
    IntervalGrammar grammar;
    const Symbol l = grammar.alphabet.add("L");
    const Symbol s = grammar.alphabet.add("S");
    grammar.rules = Morphism({Word{s, l}, Word{l}});
    EXPECT_FALSE(uniform_mask(validate(grammar).system.value(), 2));
    EXPECT_THROW((void)uniform_mask(splits_into(2), 0), std::invalid_argument);
}

TEST(CellMask, IsNoneWithoutWeights) {
    EXPECT_FALSE(uniform_mask(std::vector<CellChild>{}));
    EXPECT_FALSE(uniform_mask(std::vector<CellChild>{{0, {}}}));
}

} // namespace
} // namespace internode
