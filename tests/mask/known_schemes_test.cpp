// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/mask/known_schemes.h"

#include "tests/fixtures/masks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

std::vector<std::string> names(const UniformMask& mask) {
    std::vector<std::string> all;
    for (const KnownScheme& scheme : known_schemes(mask)) all.push_back(scheme.name);
    return all;
}

using Names = std::vector<std::string>;
using tests::mask_of;

TEST(KnownSchemes, MasksNamedAfterOthersAreWhatTheyAre) {
    // 1/8, 6/8, 1/8 and 1/2, 1/2: published under the names of Dyn, Levin and Micchelli.
    EXPECT_EQ(names(mask_of({1, 4, 6, 4, 1}, 8, 2, -2)),
              (Names{"uniform cubic B-spline", "Lane-Riesenfeld with n = 2"}));
}

TEST(KnownSchemes, ChaikinHasFourNames) {
    EXPECT_EQ(names(mask_of({1, 3, 3, 1}, 4)),
              (Names{"uniform quadratic B-spline", "Lane-Riesenfeld with n = 1", "Chaikin's corner cutting",
                     "corner cutting at 1/4 and 3/4 of each edge"}));
}

TEST(KnownSchemes, SplinesOfEveryDegreeAndArity) {
    for (std::size_t arity = 2; arity <= 4; ++arity) {
        UniformMask mask{.arity = arity, .first = 5, .coefficients = std::vector<Rational>(arity, Rational(1))};
        for (std::size_t degree = 0; degree <= 9; ++degree) {
            const auto found = known_schemes(mask);
            ASSERT_FALSE(found.empty());
            EXPECT_EQ(found[0].family, SchemeFamily::BSpline);
            EXPECT_EQ(found[0].parameters[0], Rational(static_cast<unsigned long>(degree)));
            std::vector<Rational> next(mask.coefficients.size() + arity - 1);
            for (std::size_t k = 0; k < mask.coefficients.size(); ++k)
                for (std::size_t r = 0; r < arity; ++r)
                    next[k + r] += mask.coefficients[k] / Rational(static_cast<unsigned long>(arity));
            mask.coefficients = next;
        }
    }
    EXPECT_EQ(names(mask_of({1, 2, 3, 2, 1}, 3, 3)), Names{"uniform linear B-spline, arity 3"});
}

TEST(KnownSchemes, FourPointsWithTheirTension) {
    EXPECT_EQ(names(mask_of({-1, 0, 9, 16, 9, 0, -1}, 16, 2, -3)),
              (Names{"4-point scheme with tension w = 1/16 (Dyn, Levin and Gregory)",
                     "4-point scheme of Deslauriers and Dubuc"}));
    EXPECT_EQ(names(mask_of({-1, 0, 5, 8, 5, 0, -1}, 8)), Names{"4-point scheme with tension w = 1/8"});
    EXPECT_EQ(names(mask_of({1, 0, 7, 16, 7, 0, 1}, 16)), Names{"4-point scheme with tension w = -1/16"});
    EXPECT_TRUE(names(mask_of({-1, 0, 9, 16, 9, 0, -2}, 16)).empty());
}

TEST(KnownSchemes, SixPointsWithTheirParameter) {
    EXPECT_EQ(names(mask_of({3, 0, -25, 0, 150, 256, 150, 0, -25, 0, 3}, 256)),
              (Names{"6-point scheme with theta = 3/256 (Weissman)", "6-point scheme of Deslauriers and Dubuc"}));
    EXPECT_EQ(names(mask_of({1, 0, -7, 0, 38, 64, 38, 0, -7, 0, 1}, 64)),
              Names{"6-point scheme with theta = 1/64 (Weissman)"});
}

TEST(KnownSchemes, LagrangeWeightsReproduceTheirPolynomials) {
    for (std::size_t n = 1; n <= 6; ++n)
        for (const Rational& x : {Rational(1, 2), Rational(1, 4), Rational(-2, 3)}) {
            const auto weights = lagrange_weights(n, x);
            for (std::size_t degree = 0; degree < 2 * n; ++degree) {
                Rational sum = 0;
                Rational expected = 1;
                for (std::size_t i = 0; i < degree; ++i) expected *= x;
                for (std::size_t i = 0; i < weights.size(); ++i) {
                    Rational term = weights[i];
                    const Rational node(static_cast<long>(i) + 1 - static_cast<long>(n));
                    for (std::size_t k = 0; k < degree; ++k) term *= node;
                    sum += term;
                }
                EXPECT_EQ(sum, expected);
            }
        }
}

TEST(KnownSchemes, TwoNPointSchemesOfAnySize) {
    for (std::size_t n = 2; n <= 6; ++n) {
        const auto weights = lagrange_weights(n, Rational(1, 2));
        UniformMask mask{.arity = 2, .first = 0, .coefficients = std::vector<Rational>(4 * n - 1)};
        for (std::size_t i = 0; i < 2 * n; ++i) mask.coefficients[2 * i] = weights[i];
        mask.coefficients[2 * n - 1] = 1;
        const auto found = known_schemes(mask);
        EXPECT_TRUE(std::ranges::any_of(found, [&](const KnownScheme& scheme) {
            return scheme.family == SchemeFamily::DeslauriersDubuc &&
                   scheme.parameters[0] == Rational(static_cast<unsigned long>(2 * n));
        }));
    }
}

TEST(KnownSchemes, DualFourPoints) {
    EXPECT_EQ(names(mask_of({-5, -7, 35, 105, 105, 35, -7, -5}, 128)),
              Names{"dual 4-point scheme (interpolation at 1/4 and 3/4)"});
}

TEST(KnownSchemes, CornerCuttingElsewhere) {
    EXPECT_EQ(names(mask_of({1, 2, 2, 1}, 3)), Names{"corner cutting at 1/3 and 2/3 of each edge"});
    EXPECT_TRUE(names(mask_of({3, 1, 1, 3}, 4)).empty()) << "the new points in the wrong order";
    EXPECT_TRUE(names(mask_of({-1, 3, 5, 1}, 4)).empty()) << "beyond the edge";
}

TEST(KnownSchemes, RefusesWhatIsNoMask) {
    EXPECT_THROW((void)known_schemes(UniformMask{}), std::invalid_argument);
}

} // namespace
} // namespace internode
