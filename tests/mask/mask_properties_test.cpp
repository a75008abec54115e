// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/mask/mask_properties.h"

#include "tests/fixtures/masks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

using tests::mask_of;

/// p'_k = Σ a_{k-mj} p_j of the samples p_j = f(j), as the definition has it.
template<class Function>
Rational refined(const UniformMask& mask, std::ptrdiff_t k, Function f) {
    Rational sum = 0;
    const auto m = static_cast<std::ptrdiff_t>(mask.arity);
    for (std::ptrdiff_t j = k - 40; j <= k + 40; ++j) {
        const std::ptrdiff_t i = k - m * j - mask.first;
        if (i >= 0 && i < static_cast<std::ptrdiff_t>(mask.coefficients.size()))
            sum += mask.coefficients[static_cast<std::size_t>(i)] * f(Rational(j));
    }
    return sum;
}

/// Whether the new sequence of x^degree has vanishing differences of order degree + 1.
bool generates(const UniformMask& mask, std::size_t degree) {
    std::vector<Rational> values;
    for (std::ptrdiff_t k = 0; k < 12; ++k)
        values.push_back(refined(mask, k, [&](const Rational& x) { return tests::power(x, degree); }));
    for (std::size_t order = 0; order <= degree; ++order) {
        for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = values[i + 1] - values[i];
        values.pop_back();
    }
    return std::ranges::all_of(values, [](const Rational& value) { return value == 0; });
}

bool reproduces(const UniformMask& mask, std::size_t degree, const Rational& shift) {
    const Rational m(static_cast<unsigned long>(mask.arity));
    for (std::ptrdiff_t k = 0; k < 6; ++k) {
        const Rational at = (Rational(k) - shift) / m;
        if (refined(mask, k, [&](const Rational& x) { return tests::power(x, degree); }) != tests::power(at, degree))
            return false;
    }
    return true;
}

template<class Holds>
std::optional<std::size_t> largest(Holds holds) {
    std::optional<std::size_t> degree;
    for (std::size_t d = 0; d < 6 && holds(d); ++d) degree = d;
    return degree;
}

void expect_the_definitions(const UniformMask& mask) {
    const MaskProperties properties = mask_properties(mask);
    EXPECT_EQ(properties.generation_degree, largest([&](std::size_t d) { return generates(mask, d); }));
    EXPECT_EQ(properties.reproduction_degree,
              largest([&](std::size_t d) { return reproduces(mask, d, properties.shift); }));
}

TEST(MaskProperties, SymbolsOfThePapersSchemes) {
    EXPECT_EQ(mask_properties(mask_of({1, 3, 3, 1}, 4, 2, -1)).symbol, "1/4 z^-1 (1 + z)^3");
    EXPECT_EQ(mask_properties(mask_of({1, 4, 6, 4, 1}, 8, 2, -2)).symbol, "1/8 z^-2 (1 + z)^4");
    EXPECT_EQ(mask_properties(mask_of({-1, 0, 9, 16, 9, 0, -1}, 16, 2, -3)).symbol,
              "1/16 z^-3 (1 + z)^4 (-1 + 4 z - z^2)");
    EXPECT_EQ(mask_properties(mask_of({1, 2, 3, 2, 1}, 3, 3)).symbol, "1/3 (1 + z + z^2)^2");
    EXPECT_EQ(mask_properties(mask_of({1, 1, 1, 1}, 1, 4)).symbol, "(1 + z + ... + z^3)");
    EXPECT_EQ(mask_properties(mask_of({1, 2}, 1, 2)).symbol, "(1 + 2 z)");
    EXPECT_EQ(mask_properties(mask_of({1}, 1, 2)).symbol, "1");
    EXPECT_EQ(mask_properties(mask_of({-2, -1}, 1, 2)).symbol, "-1 (2 + z)");
    EXPECT_EQ(mask_properties(mask_of({1, -1}, 1, 2)).symbol, "(1 - z)") << "a sum of 0: the first is positive";
    EXPECT_EQ(mask_properties(mask_of({-1, 1}, 1, 2)).symbol, "-1 (1 - z)");
}

TEST(MaskProperties, FourPointReproducesCubicsAndStays) {
    const MaskProperties properties = mask_properties(mask_of({-1, 0, 9, 16, 9, 0, -1}, 16, 2, -3));
    EXPECT_EQ(properties.generation_degree, 3U);
    EXPECT_EQ(properties.reproduction_degree, 3U);
    EXPECT_EQ(properties.shift, 0);
    EXPECT_TRUE(properties.interpolatory);
    EXPECT_EQ(properties.symmetry, MaskSymmetry::Odd);
    EXPECT_EQ(properties.support_first, -3);
    EXPECT_EQ(properties.support_last, 3);
}

TEST(MaskProperties, SplinesGenerateTheirDegreeAndReproduceLines) {
    UniformMask mask = mask_of({1, 1}, 1);
    for (std::size_t degree = 1; degree <= 8; ++degree) {
        std::vector<Rational> next(mask.coefficients.size() + 1);
        for (std::size_t k = 0; k < mask.coefficients.size(); ++k) {
            next[k] += mask.coefficients[k] / 2;
            next[k + 1] += mask.coefficients[k] / 2;
        }
        mask.coefficients = next;
        const MaskProperties properties = mask_properties(mask);
        EXPECT_EQ(properties.generation_degree, degree);
        EXPECT_EQ(properties.reproduction_degree, 1U);
        EXPECT_EQ(properties.shift, Rational(static_cast<unsigned long>(degree + 1)) / 2);
        EXPECT_EQ(properties.symmetry, degree % 2 == 0 ? MaskSymmetry::Even : MaskSymmetry::Odd);
        EXPECT_EQ(properties.interpolatory, degree == 1);
        EXPECT_EQ(properties.support_last, Rational(static_cast<unsigned long>(degree + 1)));
    }
}

TEST(MaskProperties, AreWhatTheDefinitionsSayForAllSmallMasks) {
    // All masks of up to five quarters between -2 and 4 that begin and end with something: binary, first = -1.
    for (std::size_t length = 1; length <= 5; ++length) {
        std::vector<long> numerators(length, -2);
        while (true) {
            if (numerators.front() != 0 && numerators.back() != 0)
                expect_the_definitions(mask_of(numerators, 4, 2, -1));
            std::size_t i = 0;
            while (i < length && ++numerators[i] > 4) numerators[i++] = -2;
            if (i == length) break;
        }
    }
}

TEST(MaskProperties, AreWhatTheDefinitionsSayForSchemesWithFactors) {
    // s(z)^power times every quotient of up to three eighths, arities 2 and 3.
    for (std::size_t arity = 2; arity <= 3; ++arity)
        for (long a = -3; a <= 3; ++a)
            for (long b = -3; b <= 3; ++b) {
                std::vector<Rational> coefficients{fraction(a, 8), fraction(b, 8), fraction(a, 8)};
                for (std::size_t power = 0; power <= 4; ++power) {
                    UniformMask mask{.arity = arity, .first = -2, .coefficients = coefficients};
                    while (!mask.coefficients.empty() && mask.coefficients.back() == 0) mask.coefficients.pop_back();
                    if (!mask.coefficients.empty() && mask.coefficients.front() != 0) expect_the_definitions(mask);
                    std::vector<Rational> next(coefficients.size() + arity - 1);
                    for (std::size_t k = 0; k < coefficients.size(); ++k)
                        for (std::size_t r = 0; r < arity; ++r) next[k + r] += coefficients[k];
                    coefficients = next;
                }
            }
}

TEST(MaskProperties, SumsOfTheResidueClasses) {
    const MaskProperties properties = mask_properties(mask_of({1, 2, 3, 4}, 2, 2, -1));
    ASSERT_EQ(properties.sums.size(), 2U);
    EXPECT_EQ(properties.sums[0], 3);
    EXPECT_EQ(properties.sums[1], 2);
    EXPECT_FALSE(properties.sums_are_one);
    EXPECT_FALSE(properties.reproduction_degree);
}

TEST(MaskProperties, RefusesWhatIsNoMask) {
    EXPECT_THROW((void)mask_properties(UniformMask{.arity = 1, .first = 0, .coefficients = {Rational(1)}}),
                 std::invalid_argument);
    EXPECT_THROW((void)mask_properties(UniformMask{}), std::invalid_argument);
}

} // namespace
} // namespace internode
