// SPDX-License-Identifier: MIT
//
// What is called proved is compared without rounding. Of schemes with two rows the spectral radii of all products are
// roots of quadratic equations, so that each bound is a question about the sign of a rational.

#include "internode/mask/joint_radius.h"

#include "internode/algebra/fraction.h"
#include "internode/mask/smoothness.h"
#include "tests/fixtures/masks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace internode {
namespace {

using Two = std::array<Rational, 4>; // a b, c d

Two product(const Two& a, const Two& b) {
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}

/// -1, 0, 1: the value is smaller than, equal to, larger than the largest modulus of an eigenvalue.
int against_radius(const Rational& value, const Two& matrix) {
    const Rational trace = abs(matrix[0] + matrix[3]);
    const Rational determinant = matrix[0] * matrix[3] - matrix[1] * matrix[2];
    const Rational discriminant = trace * trace - 4 * determinant;
    if (discriminant < 0) return sgn(value * value - determinant); // a pair of conjugates
    const Rational beyond = 2 * value - trace;                     // compared with the root of the discriminant
    return beyond < 0 && discriminant > 0 ? -1 : sgn(beyond * abs(beyond) - discriminant);
}

/// Whether value^k is at most, and a bit of 2^-60 more is above, the best spectral radius of a product of k <= 5 of
/// (d_{j-1}, d_j) -> (d'_{2j}, d'_{2j+1}) and (d_j, d_{j+1}) -> (d'_{2j+1}, d'_{2j+2}).
bool is_best_lower_bound(const Rational& value, const std::vector<Rational>& b) {
    const std::array<Two, 2> steps{Two{b[2], b[0], 0, b[1]}, Two{b[1], 0, b[2], b[0]}};
    const Rational more = value + Rational(1) / (Integer(1) << 60);
    bool reached = false;
    std::vector<Two> products{{1, 0, 0, 1}};
    for (std::size_t k = 1; k <= 5; ++k) {
        std::vector<Two> longer;
        for (const Two& matrix : products)
            for (const Two& step : steps) longer.push_back(product(matrix, step));
        products = std::move(longer);
        for (const Two& matrix : products) {
            reached = reached || against_radius(tests::power(value, k), matrix) <= 0;
            if (against_radius(tests::power(more, k), matrix) < 0) return false;
        }
    }
    return reached;
}

/// Three coefficients with denominators up to 9.
std::vector<std::vector<Rational>> random_schemes() {
    std::mt19937 random(20);
    std::vector<std::vector<Rational>> schemes;
    for (int i = 0; i < 150; ++i) {
        std::vector<Rational> scheme;
        for (int k = 0; k < 3; ++k)
            scheme.push_back(fraction(static_cast<long>(random() % 13) - 6, 1 + static_cast<long>(random() % 9)));
        schemes.push_back(scheme);
    }
    schemes.push_back({fraction(1, 3), fraction(1, 3), fraction(1, 3)}); // differences of corner cutting at thirds
    return schemes;
}

TEST(JointRadius, LowerBoundIsTheBestSpectralRadiusRoundedDown) {
    std::size_t irrational = 0;
    for (const std::vector<Rational>& scheme : random_schemes()) {
        const JointRadius radius = joint_radius(scheme, 2);
        if (radius.positive) continue;
        EXPECT_TRUE(is_best_lower_bound(radius.lower, scheme)) << scheme[0] << ' ' << scheme[1] << ' ' << scheme[2];
        if (radius.lower.get_den() > 1000) ++irrational;
    }
    EXPECT_GT(irrational, 20U) << "only rounded bounds can be rounded the wrong way";
}

TEST(JointRadius, UpperBoundIsTheRootOfTheNormRoundedUp) {
    const Rational bit = Rational(1) / (Integer(1) << 64);
    std::size_t rounded = 0;
    for (const std::vector<Rational>& scheme : random_schemes()) {
        const JointRadius radius = joint_radius(scheme, 2, RadiusBounds::Norms);
        EXPECT_GE(tests::power(radius.upper, radius.steps), radius.norm);
        if (tests::power(radius.upper, radius.steps) == radius.norm) continue;
        EXPECT_LT(tests::power(radius.upper - bit, radius.steps), radius.norm);
        ++rounded;
    }
    EXPECT_GT(rounded, 20U);
}

TEST(JointRadius, OfCornerCuttingAtThirdsIsBetweenItsBounds) {
    // (1 + √5)/6, above which (6x - 1)² > 5.
    const std::vector<Rational> thirds{fraction(1, 3), fraction(1, 3), fraction(1, 3)};
    const JointRadius radius = joint_radius(thirds, 2);
    EXPECT_LE(tests::power(6 * radius.lower - 1, 2), 5);
    EXPECT_GT(tests::power(6 * (radius.lower + Rational(1) / (Integer(1) << 60)) - 1, 2), 5);
    EXPECT_GE(tests::power(6 * radius.upper - 1, 2), 5);
}

TEST(JointRadius, OfPositiveSchemesOfFiveIsEnclosed) {
    // Round the centre, (x_0, x_1 = x_-1) becomes (c x_0 + 2a x_1, b x_0 + b x_1).
    std::size_t enclosed = 0;
    for (long a = -2; a <= 2; ++a)
        for (long b = -6; b <= 6; b += 3)
            for (long c = 4; c <= 14; c += 5) {
                const std::vector<Rational> scheme{fraction(a, 7), fraction(b, 7), fraction(c, 7), fraction(b, 7),
                                                   fraction(a, 7)};
                const JointRadius radius = joint_radius(scheme, 2);
                const bool positive = [&] { // c + 2b cos ω + 2a cos 2ω = 4a y² + 2b y + c - 2a for y = cos ω
                    for (int step = -64; step <= 64; ++step)
                        if (fraction(4 * a * step * step, 4096) + fraction(2 * b * step, 64) + c - 2 * a < 0)
                            return false;
                    return true;
                }();
                EXPECT_TRUE(positive || !radius.positive) << a << ' ' << b << ' ' << c;
                if (!radius.positive) continue;
                const Two centre{scheme[2], 2 * scheme[0], scheme[1], scheme[1]};
                EXPECT_LE(against_radius(radius.lower, centre), 0) << a << ' ' << b << ' ' << c;
                EXPECT_GE(against_radius(radius.upper, centre), 0) << a << ' ' << b << ' ' << c;
                EXPECT_LE(radius.upper - radius.lower, fraction(1, 1'000'000'000));
                ++enclosed;
            }
    EXPECT_GT(enclosed, 15U);
}

/// The product of factors (z + 1/z - x) with x = numerator/2.
std::vector<Rational> with_zeros(const std::vector<long>& numerators) {
    std::vector<Rational> scheme{1};
    for (const long numerator : numerators) {
        std::vector<Rational> next(scheme.size() + 2);
        for (std::size_t i = 0; i < scheme.size(); ++i) {
            next[i] += scheme[i];
            next[i + 1] -= fraction(numerator, 2) * scheme[i];
            next[i + 2] += scheme[i];
        }
        scheme = next;
    }
    return scheme;
}

TEST(JointRadius, ASchemeWithDoubleZerosOnlyDoesNotChangeItsSign) {
    for (const std::vector<long>& zeros : std::vector<std::vector<long>>{{1, 1}, {0, 0}, {-3, -3, 2, 2}, {1, 1, 1, 1}})
        EXPECT_TRUE(joint_radius(with_zeros(zeros), 2).positive) << zeros.front();
    for (const std::vector<long>& zeros : std::vector<std::vector<long>>{{1}, {1, 1, 1}, {0, 0, 1}, {-3, -3, 2}})
        EXPECT_FALSE(joint_radius(with_zeros(zeros), 2).positive) << zeros.front();
    // Simple zeros at z = -1 touch, those beyond are none on the circle.
    EXPECT_TRUE(joint_radius(with_zeros({-4}), 2).positive);
    EXPECT_TRUE(joint_radius(with_zeros({-5}), 2).positive);
    EXPECT_FALSE(joint_radius(with_zeros({5}), 2).positive) << "negative everywhere";
}

TEST(JointRadius, OfBSplinesIsOneHoweverWideTheirMasks) {
    for (const std::size_t degree : {5U, 13U, 17U}) { // products are of masks with up to 13 coefficients
        std::vector<Rational> scheme = with_zeros(std::vector<long>((degree + 1) / 2, -4));
        for (Rational& coefficient : scheme) coefficient /= Integer(1) << degree;
        const JointRadius radius = joint_radius(scheme, 2);
        EXPECT_TRUE(radius.positive);
        EXPECT_LE(radius.lower, 1);
        EXPECT_GE(radius.lower, 1 - fraction(1, 1'000'000'000)) << degree;
        EXPECT_EQ(radius.upper, 1);
    }
}

TEST(JointRadius, OfAveragesIsOneUpToThirteenCoefficients) {
    std::vector<Rational> scheme{fraction(3, 2), fraction(1, 2)};
    while (scheme.size() < 13) { // times (1 + z)/2
        scheme.emplace_back(0);
        for (std::size_t i = scheme.size() - 1; i > 0; --i) scheme[i] = (scheme[i] + scheme[i - 1]) / 2;
        scheme[0] /= 2;
        const JointRadius radius = joint_radius(scheme, 2);
        EXPECT_FALSE(radius.positive) << "no symmetry";
        EXPECT_LE(radius.lower, 1);
        EXPECT_GE(radius.lower, 1 - fraction(1, 1'000'000'000)) << scheme.size();
        EXPECT_EQ(radius.upper, 1);
    }
}

/// log_m in twice the bits that matter here: a long double errs by 1e-19, the bounds leave 1e-12.
long double exponent_of(const Rational& radius, std::size_t order, std::size_t arity) {
    long numerator_exponent = 0;
    long denominator_exponent = 0;
    const double numerator = mpz_get_d_2exp(&numerator_exponent, radius.get_num_mpz_t());
    const double denominator = mpz_get_d_2exp(&denominator_exponent, radius.get_den_mpz_t());
    const long double two = std::log2(static_cast<long double>(numerator)) -
                            std::log2(static_cast<long double>(denominator)) +
                            static_cast<long double>(numerator_exponent - denominator_exponent);
    return static_cast<long double>(order) - 1 - two / std::log2(static_cast<long double>(arity));
}

TEST(Smoothness, HolderExponentsAreRoundedOutwards) {
    std::size_t below = 0;
    std::size_t above = 0;
    for (long p = 1; p <= 4; ++p)
        for (long q = p + 1; q <= 6; ++q) { // corners cut at p/q, and the four-point scheme with that tension
            const Rational t = fraction(p, 2 * q);
            const UniformMask cut{.arity = 2, .first = 0, .coefficients = {t, 1 - t, 1 - t, t}};
            const Rational w = t / 4;
            const UniformMask four{
                .arity = 2, .first = -3, .coefficients = {-w, 0, fraction(1, 2) + w, 1, fraction(1, 2) + w, 0, -w}};
            for (const UniformMask& mask : {cut, four}) {
                const Smoothness found = smoothness(mask).value();
                if (!found.holder_lower || !found.holder_upper) continue;
                long double best = 0;
                for (const DifferenceScheme& scheme : found.differences)
                    best = std::max(best, exponent_of(scheme.radius.upper, scheme.order, 2));
                EXPECT_LE(static_cast<long double>(*found.holder_lower), best + 1e-15L);
                EXPECT_NEAR(static_cast<double>(best - *found.holder_lower), 0, 1e-11);
                const DifferenceScheme& last = found.differences.back();
                const long double highest = exponent_of(last.radius.lower, last.order, 2);
                EXPECT_GE(static_cast<long double>(*found.holder_upper), highest - 1e-15L);
                EXPECT_NEAR(static_cast<double>(*found.holder_upper - highest), 0, 1e-11);
                below += static_cast<long double>(*found.holder_lower) < best ? 1 : 0;
                above += static_cast<long double>(*found.holder_upper) > highest ? 1 : 0;
            }
        }
    EXPECT_GT(below, 5U);
    EXPECT_GT(above, 5U);
}

} // namespace
} // namespace internode
