// SPDX-License-Identifier: MIT
//
// Every numbered production of S0 and S1 gives the result that its paper says.

#include "internode/algebra/fraction.h"
#include "tests/point/systems.h"

#include "internode/point/start_word.h"
#include "internode/point/strands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace internode {
namespace {

PointSystem bundled(const std::string& name, const PointSettings& settings = {}) {
    return point_system(text_of_data(name), settings);
}

std::vector<double> subdivided(const std::string& name, const std::vector<double>& points, std::uint64_t cycles = 1,
                               const PointSettings& settings = {}, const DeriveOptions& options = {}) {
    const PointSystem system = bundled(name, settings);
    return points_of(system, derived(system, input_word(system, points), cycles, options));
}

/// A polygon of n points with coordinates that are exact in doubles for many steps.
std::vector<double> polygon(std::size_t n, std::size_t dimension = 2) {
    std::vector<double> points;
    for (std::size_t i = 0; i < n * dimension; ++i) points.push_back(static_cast<double>((i * i * 7 + 3 * i) % 31));
    return points;
}

/// The points turned so that the given one comes first.
std::vector<double> turned(const std::vector<double>& points, std::size_t first, std::size_t dimension = 2) {
    std::vector<double> result;
    for (std::size_t i = 0; i < points.size(); ++i) result.push_back(points[(i + first * dimension) % points.size()]);
    return result;
}

bool equal_up_to_a_shift(const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t first = 0; first < b.size() / 2; ++first)
        if (a == turned(b, first)) return true;
    return false;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "coordinate " << i;
}

const std::vector<double> square{0, 0, 0, 1, 1, 1, 1, 0};

TEST(PaperS0, Equation12FollowsFrom9To11WithTheErratum) {
    const PointSystem system = bundled("s0/11");
    EXPECT_EQ(shown(system, axiom_word(system)), "A(1.5) B(2, 3) A(4.5)");
    EXPECT_EQ(shown(system, derived(system, axiom_word(system), 1)), "A(4) A(3.5) A(7.5) A(10)");
}

TEST(PaperS0, Equation13CutsTheCornersOfASquare) {
    EXPECT_EQ(subdivided("s0/13", square),
              (std::vector<double>{0.25, 0, 0, 0.25, 0, 0.75, 0.25, 1, 0.75, 1, 1, 0.75, 1, 0.25, 0.75, 0}));
}

TEST(PaperS0, Equations17To20AreEquation13UpToAShift) {
    for (const std::size_t n : {3U, 4U, 7U}) {
        const std::vector<double> expected = subdivided("s0/13", polygon(n), 2);
        for (const char* name : {"s0/17", "s0/18", "s0/20"})
            EXPECT_TRUE(equal_up_to_a_shift(subdivided(name, polygon(n), 2), expected)) << name << ", " << n;
    }
}

TEST(PaperS0, Equations22And23AreTheSameCubic) {
    EXPECT_TRUE(equal_up_to_a_shift(subdivided("s0/22", polygon(5), 3), subdivided("s0/23", polygon(5), 3)));
}

TEST(PaperS0, Equations25And26AreTheSameFourPointScheme) {
    EXPECT_TRUE(equal_up_to_a_shift(subdivided("s0/25", polygon(6), 2), subdivided("s0/26", polygon(6), 2)));
}

TEST(PaperS0, TheFourPointSchemeInterpolates) {
    const std::vector<double> points = polygon(6);
    const std::vector<double> finer = subdivided("s0/25", points);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(finer[4 * i], points[2 * i]);
        EXPECT_EQ(finer[4 * i + 1], points[2 * i + 1]);
    }
}

/// Matrix (27) times the points.
std::vector<double> open_chaikin(const std::vector<double>& points) {
    const std::size_t n = points.size() / 2;
    std::vector<double> result;
    const auto add = [&](double a, std::size_t i, double b, std::size_t j) {
        for (std::size_t k = 0; k < 2; ++k) result.push_back(a * points[2 * i + k] + b * points[2 * j + k]);
    };
    add(1, 0, 0, 0);
    add(0.5, 0, 0.5, 1);
    for (std::size_t i = 1; i + 2 < n; ++i) {
        add(0.75, i, 0.25, i + 1);
        add(0.25, i, 0.75, i + 1);
    }
    add(0.5, n - 2, 0.5, n - 1);
    add(1, n - 1, 0, 0);
    return result;
}

TEST(PaperS0, OpenChaikinIsMatrix27InBothForms) {
    for (std::size_t n = 4; n <= 12; ++n) {
        const std::vector<double> once = open_chaikin(polygon(n));
        EXPECT_EQ(subdivided("s0/28-33", polygon(n)), once) << n;
        EXPECT_EQ(subdivided("s0/34-36", polygon(n)), once) << n;
        EXPECT_EQ(subdivided("s0/28-33", polygon(n), 3), open_chaikin(open_chaikin(once))) << n;
        EXPECT_EQ(subdivided("s0/34-36", polygon(n), 3), open_chaikin(open_chaikin(once))) << n;
    }
}

TEST(PaperS0, Equation38UndoesEquation13InPhaseZero) {
    for (const std::size_t n : {3U, 4U, 9U}) {
        EXPECT_EQ(subdivided("s0/38", subdivided("s0/13", polygon(n))), polygon(n)) << n;
        EXPECT_EQ(subdivided("s0/38", subdivided("s0/13", polygon(n), 3), 3), polygon(n)) << n;
        EXPECT_NE(subdivided("s0/38", subdivided("s0/13", polygon(n)), 1, {}, {.phase = 1}), polygon(n)) << n;
    }
}

TEST(PaperS0, Equation38UndoesEquation17InPhaseOne) {
    EXPECT_EQ(subdivided("s0/38", subdivided("s0/17", polygon(5)), 1, {}, {.phase = 1}), polygon(5));
}

using Matrix = std::vector<std::vector<Rational>>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result(a.size(), std::vector<Rational>(b[0].size(), 0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b[0].size(); ++j)
            for (std::size_t k = 0; k < b.size(); ++k) result[i][j] += a[i][k] * b[k][j];
    return result;
}

/// Ones at (i, i + shift mod n).
Matrix shifted_identity(std::size_t n, std::size_t shift) {
    Matrix result(n, std::vector<Rational>(n, 0));
    for (std::size_t i = 0; i < n; ++i) result[i][(i + shift) % n] = 1;
    return result;
}

TEST(PaperS0, Matrix37AsPrintedInvertsEquation17AndNotMatrix14) {
    constexpr std::size_t n = 6;
    const Rational quarter(1, 4);
    const Rational half_more(3, 4);
    Matrix printed(n, std::vector<Rational>(2 * n, 0)); // row i pairs the points 2i - 1 and 2i, from 0
    Matrix chaikin(2 * n, std::vector<Rational>(n, 0)); // (14)
    Matrix left(2 * n, std::vector<Rational>(n, 0));    // (17)
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        printed[i][(2 * i + 2 * n - 2) % (2 * n)] = printed[i][2 * i + 1] = -quarter;
        printed[i][(2 * i + 2 * n - 1) % (2 * n)] = printed[i][2 * i] = half_more;
        chaikin[2 * i][before] = chaikin[2 * i + 1][(i + 1) % n] = quarter;
        chaikin[2 * i][i] = chaikin[2 * i + 1][i] = half_more;
        left[2 * i][before] = left[2 * i + 1][i] = half_more;
        left[2 * i][i] = left[2 * i + 1][before] = quarter;
    }
    for (std::size_t shift = 0; shift < n; ++shift)
        EXPECT_NE(product(printed, chaikin), shifted_identity(n, shift)) << shift;
    EXPECT_EQ(product(printed, left), shifted_identity(n, n - 1));
}

TEST(PaperS1, Equation2GivesThePrintedWord) {
    const PointSystem system = bundled("s1/2");
    EXPECT_EQ(shown(system, derived(system, axiom_word(system), 1)), "A(4) A(3.5) A(7.5) B(10) C(1)");
}

std::string word_after(const std::string& name, std::uint64_t cycles, const PointSettings& settings = {}) {
    const PointSystem system = bundled(name, settings);
    return shown(system, derived(system, input_word(system, polygon(5)), cycles));
}

TEST(PaperS1, Equations8And10WithOneAveragingAreTheSameWords) {
    for (std::uint64_t cycles = 0; cycles <= 3; ++cycles)
        EXPECT_EQ(word_after("s1/8", cycles), word_after("s1/10", cycles, {.constants = {{"n", 1}}})) << cycles;
}

TEST(PaperS1, Equation7HasThePointsOfEquation8UpToOneShift) {
    const std::vector<double> expected = subdivided("s1/8", polygon(5));
    EXPECT_EQ(subdivided("s1/7", polygon(5)), turned(expected, expected.size() / 2 - 1));
    EXPECT_TRUE(equal_up_to_a_shift(subdivided("s1/7", polygon(5), 3), subdivided("s1/8", polygon(5), 3)));
}

TEST(PaperS1, Equation10WithTwoAveragingsIsTheCubicOfEquation22) {
    EXPECT_TRUE(equal_up_to_a_shift(subdivided("s1/10", polygon(5), 2, {.constants = {{"n", 2}}}),
                                    subdivided("s0/22", polygon(5), 2)));
}

TEST(PaperS1, Equation9DrawsTheEdges) {
    const PointSystem system = bundled("s1/9");
    const Derivation drawn = interpret(system, input_word(system, square));
    ASSERT_FALSE(drawn.problem);
    EXPECT_EQ(strands(drawn.word, system, 1).lines,
              (std::vector<double>{0, 0, 0, 1, 0, 1, 1, 1, 1, 1, 1, 0, 1, 0, 0, 0}));
}

/// Σ C(n, i) (1 - t)^(n - i) t^i p_i, each term by itself.
std::vector<double> bernstein(const std::vector<double>& points, double t) {
    const std::size_t degree = points.size() / 2 - 1;
    std::vector<double> result(2, 0);
    double binomial = 1;
    for (std::size_t i = 0; i <= degree; ++i) {
        double weight = binomial;
        for (std::size_t k = 0; k < degree; ++k) weight *= k < i ? t : 1 - t;
        for (std::size_t k = 0; k < 2; ++k) result[k] += weight * points[2 * i + k];
        binomial = binomial * static_cast<double>(degree - i) / static_cast<double>(i + 1);
    }
    return result;
}

TEST(PaperS1, DeCasteljauIsBernsteinEvaluation) {
    for (const char* name : {"s1/11", "s1/12", "s1/13"})
        for (std::size_t degree = 1; degree <= 10; ++degree)
            for (const Rational& t :
                 {Rational(0), Rational(1, 4), Rational(1, 3), Rational(1, 2), Rational(9, 10), Rational(1)}) {
                const std::vector<double> points = polygon(degree + 1);
                expect_near(subdivided(name, points, degree, {.constants = {{"t", t}}}),
                            bernstein(points, to_double(t)), 1e-13);
            }
}

/// The points that (14) to (16) make of a polygon: n - 1 steps of (14), then one of (16).
std::vector<double> by_any_degree(std::size_t points, std::uint64_t cycles) {
    return subdivided("s1/14-16", polygon(points), cycles,
                      {.constants = {{"n", Rational(static_cast<unsigned long>(points - 1))}}});
}

TEST(PaperS1, Equations14To16OnThreePointsAreEquation17) {
    for (std::uint64_t cycles = 1; cycles <= 4; ++cycles)
        EXPECT_EQ(by_any_degree(3, cycles), subdivided("s1/17", polygon(3), cycles)) << cycles;
}

TEST(PaperS1, Equations14To16OnFourPointsAreEquations18And19) {
    for (std::uint64_t cycles = 1; cycles <= 4; ++cycles) {
        EXPECT_EQ(by_any_degree(4, cycles), subdivided("s1/18", polygon(4), cycles)) << cycles;
        EXPECT_EQ(by_any_degree(4, cycles), subdivided("s1/19", polygon(4), cycles)) << cycles;
    }
}

TEST(PaperS1, RationalArcsLieOnTheirConics) {
    for (const double weight : {0.5, 1.0, 2.5})
        for (int k = 0; k <= 10; ++k) {
            const PointSystem system = bundled("s1/20-21", {.dimension = 3, .constants = {{"t", fraction(k, 10)}}});
            const ModuleWord word =
                input_word(system, std::vector<double>{0, 0, 1, weight, 2 * weight, weight, 2, 0, 1});
            const Derivation drawn = interpret(system, derived(system, word, 2));
            ASSERT_FALSE(drawn.problem);
            const std::vector<double> point = points_of(system, drawn.word, 2);
            ASSERT_EQ(point.size(), 2U);
            // Barycentric coordinates with respect to (0, 0), (1, 2), (2, 0): l1² = 4 w² l0 l2.
            const double l1 = point[1] / 2;
            const double l2 = (point[0] - l1) / 2;
            const double l0 = 1 - l1 - l2;
            EXPECT_NEAR(l1 * l1, 4 * weight * weight * l0 * l2, 1e-14) << weight << ", " << k;
        }
}

} // namespace
} // namespace internode
