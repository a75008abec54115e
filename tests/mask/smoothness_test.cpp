// SPDX-License-Identifier: MIT

#include "internode/mask/smoothness.h"

#include "internode/algebra/fraction.h"
#include "internode/mask/known_schemes.h"
#include "tests/fixtures/masks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace internode {
namespace {

using tests::mask_of;

UniformMask four_point(const Rational& w) {
    const Rational inner = Rational(1, 2) + w;
    return UniformMask{.arity = 2, .first = -3, .coefficients = {-w, 0, inner, 1, inner, 0, -w}};
}

UniformMask deslauriers_dubuc(std::size_t n) {
    const auto weights = lagrange_weights(n, Rational(1, 2));
    UniformMask mask{.arity = 2, .first = 0, .coefficients = std::vector<Rational>(4 * n - 1)};
    for (std::size_t i = 0; i < 2 * n; ++i) mask.coefficients[2 * i] = weights[i];
    mask.coefficients[2 * n - 1] = 1;
    return mask;
}

TEST(Smoothness, SplinesHaveTheirDegreeExactly) {
    for (std::size_t arity = 2; arity <= 4; ++arity) {
        UniformMask mask{.arity = arity, .first = 0, .coefficients = std::vector<Rational>(arity, Rational(1))};
        for (std::size_t degree = 0; degree <= 6; ++degree) {
            const Smoothness result = smoothness(mask).value();
            if (degree == 0) {
                EXPECT_EQ(result.convergence, SchemeConvergence::Refuted) << "steps are not continuous";
            } else {
                EXPECT_EQ(result.convergence, SchemeConvergence::Proved);
                EXPECT_EQ(result.derivatives, degree - 1);
                EXPECT_EQ(result.holder_lower, static_cast<double>(degree));
                EXPECT_EQ(result.holder_upper, static_cast<double>(degree));
                EXPECT_TRUE(result.upper_is_proved);
            }
            std::vector<Rational> next(mask.coefficients.size() + arity - 1);
            for (std::size_t k = 0; k < mask.coefficients.size(); ++k)
                for (std::size_t r = 0; r < arity; ++r)
                    next[k + r] += mask.coefficients[k] / Rational(static_cast<unsigned long>(arity));
            mask.coefficients = next;
        }
    }
}

TEST(Smoothness, FourPointsAreJustShortOfTwoDerivatives) {
    const Smoothness result = smoothness(four_point(Rational(1, 16))).value();
    EXPECT_EQ(result.convergence, SchemeConvergence::Proved);
    EXPECT_EQ(result.derivatives, 1U);
    EXPECT_EQ(result.holder_lower, 2.0);
    EXPECT_EQ(result.holder_upper, 2.0);
    EXPECT_TRUE(result.upper_is_proved);
}

TEST(Smoothness, InterpolationOfHigherDegreeAsPublished) {
    // Daubechies 1992, table of the Deslauriers-Dubuc functions: 2.830, 3.551, 4.193 for 6, 8, 10 points.
    const double published[] = {2.830, 3.551, 4.193};
    for (std::size_t n = 3; n <= 5; ++n) {
        const Smoothness result = smoothness(deslauriers_dubuc(n)).value();
        EXPECT_NEAR(*result.holder_lower, published[n - 3], 6e-4) << n;
        EXPECT_NEAR(*result.holder_upper, *result.holder_lower, 1e-9) << n;
        EXPECT_TRUE(result.differences.back().radius.positive);
    }
}

TEST(Smoothness, TensionKeepsOneDerivativeUpToItsBound) {
    // 0 < w < (sqrt(5) - 1)/8 = 0.1545…: Dyn, Gregory and Levin 1991.
    for (const Rational& w :
         {Rational(1, 1000), Rational(1, 100), Rational(1, 20), Rational(1, 10), fraction(15, 100)}) {
        const Smoothness result = smoothness(four_point(w)).value();
        EXPECT_EQ(result.convergence, SchemeConvergence::Proved) << w;
        EXPECT_GE(result.derivatives.value(), 1U) << w;
        EXPECT_LE(*result.holder_lower, *result.holder_upper);
    }
    EXPECT_EQ(smoothness(four_point(Rational(1))).value().convergence, SchemeConvergence::Refuted);
    EXPECT_EQ(smoothness(four_point(Rational(0) - Rational(1))).value().convergence, SchemeConvergence::Refuted);
}

TEST(Smoothness, OnlyFirstDifferencesThatDoNotShrinkRefuteConvergence) {
    // The four-point scheme no longer converges at w = 1/2; its second differences grow long before.
    EXPECT_EQ(smoothness(four_point(Rational(1, 2))).value().convergence, SchemeConvergence::Refuted);
    const Smoothness result = smoothness(four_point(fraction(4999, 10'000))).value();
    EXPECT_LT(result.differences.front().radius.lower, 1);
    EXPECT_GT(result.differences.back().radius.lower, 1);
    EXPECT_EQ(result.convergence, SchemeConvergence::NotDecided);
    EXPECT_EQ(result.reason, "the first differences were not seen to shrink within " +
                                 std::to_string(result.differences.front().radius.steps) + " steps");
}

TEST(Smoothness, CornerCuttingAtThirdsIsBoundedFromBothSides) {
    // d'_{2j} = (d_{j-1} + d_j)/3, d'_{2j+1} = d_j/3: two steps take (d_{j-1}, d_j) to a ninth of a Fibonacci step.
    const double radius = (1 + std::sqrt(5.0)) / 6;
    const Smoothness result = smoothness(mask_of({1, 2, 2, 1}, 3)).value();
    EXPECT_EQ(result.convergence, SchemeConvergence::Proved);
    EXPECT_NEAR(*result.holder_upper, -std::log2(radius), 1e-10);
    EXPECT_LE(*result.holder_lower, -std::log2(radius));
    EXPECT_GT(*result.holder_lower, -std::log2(radius) - 0.03);
    EXPECT_FALSE(result.upper_is_proved);
}

TEST(Smoothness, IsNotBoundedBelowWhereNothingIsDecided) {
    // Corners cut at 99/100, the two new points swapped: the products shrink, but too slowly for the norms.
    const Smoothness result = smoothness(mask_of({99, 1, 1, 99}, 100)).value();
    EXPECT_EQ(result.convergence, SchemeConvergence::NotDecided);
    EXPECT_FALSE(result.derivatives);
    EXPECT_FALSE(result.holder_lower);
    EXPECT_GT(result.holder_upper.value(), 0);
}

TEST(Smoothness, SumsThatAreNotOneRefuteConvergence) {
    const Smoothness result = smoothness(mask_of({1, 1, 1}, 2)).value();
    EXPECT_EQ(result.convergence, SchemeConvergence::Refuted);
    EXPECT_FALSE(result.derivatives);
    EXPECT_FALSE(result.holder_lower);
}

TEST(Smoothness, LongMasksAreLeftOut) {
    EXPECT_FALSE(smoothness(mask_of(std::vector<long>(65, 1), 1)));
    EXPECT_FALSE(smoothness(mask_of(std::vector<long>(9, 1), 1, 9)));
    EXPECT_THROW((void)smoothness(UniformMask{}), std::invalid_argument);
}

/// The differences of the values after `steps` steps of the impulse, as the definition has it: their largest sum of
/// absolute weights.
Rational slow_norm(const std::vector<Rational>& b, std::size_t arity, std::size_t steps) {
    std::size_t period = 1;
    std::vector<Rational> row{Rational(1)};
    for (std::size_t step = 0; step < steps; ++step) {
        std::vector<Rational> next((row.size() - 1) * arity + b.size());
        for (std::size_t j = 0; j < row.size(); ++j)
            for (std::size_t k = 0; k < b.size(); ++k) next[arity * j + k] += b[k] * row[j];
        row = next;
        period *= arity;
    }
    Rational largest = 0;
    for (std::size_t r = 0; r < period; ++r) {
        Rational sum = 0;
        for (std::size_t k = r; k < row.size(); k += period) sum += abs(row[k]);
        largest = std::max(largest, sum);
    }
    return largest;
}

TEST(JointRadius, BoundsHoldForAllSmallSchemes) {
    for (std::size_t arity = 2; arity <= 3; ++arity)
        for (long a = -3; a <= 3; ++a)
            for (long b = -3; b <= 3; ++b)
                for (long c = -3; c <= 3; ++c) {
                    std::vector<Rational> scheme{fraction(a, 2), fraction(b, 2), fraction(c, 2)};
                    const JointRadius radius = joint_radius(scheme, arity);
                    EXPECT_LE(radius.lower, radius.upper);
                    ASSERT_GT(radius.steps, 0U);
                    if (radius.steps <= 5) {
                        EXPECT_EQ(radius.norm, slow_norm(scheme, arity, radius.steps));
                    }
                    // Every norm bounds the radius from above, hence also the lower bound.
                    const double norm = to_double(slow_norm(scheme, arity, 3));
                    EXPECT_LE(to_double(radius.lower), std::cbrt(norm) + 1e-12);
                    if (radius.contracts_after && *radius.contracts_after <= 5) {
                        EXPECT_EQ(radius.contraction, slow_norm(scheme, arity, *radius.contracts_after));
                    }
                }
}

TEST(JointRadius, LongCoefficientsAreBoundedByNormsAlone) {
    const Rational third = Rational(1, 3) + fraction(1, Integer(1) << 2'000);
    const JointRadius radius = joint_radius({third, Rational(1) - third}, 2);
    EXPECT_EQ(radius.lower, 0);
    EXPECT_LT(radius.upper, 1);
    EXPECT_TRUE(radius.contracts_after);
}

TEST(JointRadius, PositiveSchemesAreExact) {
    // 2 - cos ω > 0: the scheme behind the four-point scheme.
    const JointRadius radius = joint_radius({Rational(-1, 2), Rational(2), Rational(-1, 2)}, 2);
    EXPECT_TRUE(radius.positive);
    EXPECT_EQ(radius.lower, 2);
    EXPECT_EQ(radius.upper, 2);
    EXPECT_FALSE(joint_radius({Rational(1), Rational(-1), Rational(1)}, 2).positive) << "2 cos ω - 1 changes its sign";
}

} // namespace
} // namespace internode
