// SPDX-License-Identifier: MIT

#include "internode/curve/refinement.h"

#include "internode/curve/parameter.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/words.h"
#include "tests/reference/de_boor.h"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using reference::Real;
using ::testing::ElementsAre;
using tests::all_shapes;
using tests::curve_of;
using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::random_system;
using tests::Shape;
using tests::system_with;

const int repetitions = tests::times(2);
/// Points: all twelve steps of every bundled grammar, or fewer.
const std::uint64_t max_predicted = tests::in_full() ? 20'000'000 : 100'000;

/// The largest difference of two curves over the same domain, at 3 places inside every interval of `fine`.
Real difference(const DeBoorCurve& coarse, const DeBoorCurve& fine) {
    Real worst = std::max(std::abs(coarse.begin() - fine.begin()), std::abs(coarse.end() - fine.end()));
    for (std::size_t j = fine.degree; j < fine.points.size(); ++j) {
        const Real length = fine.knots[j + 1] - fine.knots[j];
        if (length <= 0) continue;
        for (const Real part : {Real(0.1L), Real(0.5L), Real(0.9L)}) {
            const Real x = fine.knots[j] + part * length;
            const auto left = reference::de_boor(coarse, x);
            const auto right = reference::de_boor_piece(fine, j, x);
            for (std::size_t c = 0; c < left.size(); ++c) worst = std::max(worst, std::abs(left[c] - right[c]));
        }
    }
    return worst;
}

void for_random_curves(std::uint32_t seed, int times, const std::function<void(const Curve&, Random&)>& check) {
    Random random(seed);
    tests::Compared compared;
    for (int time = 0; time < times; ++time)
        for (int degree = 1; degree <= 6; ++degree)
            for (const Shape shape : all_shapes) {
                const IntervalSystem system = random_system(random);
                check(random_curve(random, system, degree, shape, 1 + random.below(6), 1 + random.below(3)), random);
                ++compared;
            }
}

TEST(Refinement, KeepsTheLimitCurve) {
    for_random_curves(1, 2 * repetitions, [](const Curve& curve, Random&) {
        const Curve fine = refine(curve, 2);
        EXPECT_LT(difference(reference::de_boor_curve(curve), reference::de_boor_curve(fine)), 1e-12L)
            << "degree " << curve.degree() << ", word " << to_string(curve.word(), curve.system().alphabet());
    });
}

TEST(Refinement, KeepsTheDomain) {
    for_random_curves(2, repetitions, [](const Curve& curve, Random&) {
        const DeBoorCurve coarse = reference::de_boor_curve(curve);
        const DeBoorCurve fine = reference::de_boor_curve(refine(curve, 3));
        EXPECT_NEAR(static_cast<double>(fine.end()), static_cast<double>(coarse.end()), 1e-12);
    });
}

TEST(Refinement, RewritesAClosedWordWithoutRotation) {
    for_random_curves(3, 1, [](const Curve& curve, Random&) {
        if (curve.ends() != Ends::Circular) return;
        EXPECT_EQ(refine(curve, 1).word(), curve.system().rules()(curve.word()));
    });
}

TEST(Refinement, CutsAnOpenWordToDegreeLettersOutsideTheDomain) {
    // d = 2, A -> BA, B -> A: domain A B A between B A and B B.
    const Word word{b, a, a, b, a, b, b};
    const Morphism rules({{b, a}, {a}});
    EXPECT_THAT(refined_word(rules, word, 2, Ends::Open), ElementsAre(b, a, b, a, a, b, a, a, a));
    EXPECT_THAT(refined_word(rules, clamped(Word{a}, 2), 2, Ends::Open), ElementsAre(o, o, b, a, o, o));
    EXPECT_THROW((void)refined_word(rules, Word{a, a, a, a}, 2, Ends::Open), std::invalid_argument);
}

TEST(Refinement, HasOnePointPerLetterOfTheNewWord) {
    for_random_curves(4, repetitions, [](const Curve& curve, Random&) {
        const Curve fine = refine(curve, 2);
        const std::size_t extra = curve.ends() == Ends::Circular ? 0 : static_cast<std::size_t>(curve.degree());
        EXPECT_EQ(fine.word().size(), fine.size() + extra);
        EXPECT_EQ(fine.domain().size() + extra, fine.size());
        EXPECT_EQ(fine.step(), 2);
        Word domain(curve.domain().begin(), curve.domain().end());
        for (int step = 0; step < 2; ++step) domain = curve.system().rules()(domain);
        EXPECT_TRUE(std::ranges::equal(fine.domain(), domain));
    });
}

TEST(Refinement, PredictsItsSizeUpTo12Steps) {
    for_random_curves(5, 1, [](const Curve& curve, Random&) {
        Refinement refinement(curve);
        for (std::uint64_t step = 0; step <= 12; ++step) {
            const RefinementSize size = refined_size(curve, step, 3000);
            if (size.exceeded) break;
            EXPECT_EQ(size.points, refinement.curve().size());
            refinement.step();
        }
    });
}

TEST(Refinement, PredictsItsSizeForEveryBundledGrammar) {
    for (const auto& [name, system] : tests::bundled_systems()) {
        Word letters;
        for (std::size_t i = 0; i < system.alphabet().size(); ++i) letters.push_back(to_symbol(i));
        for (const Ends ends : {Ends::Open, Ends::Circular}) {
            const std::size_t points = ends == Ends::Open ? 3 : letters.size();
            const Word word = ends == Ends::Open ? repeated(letters, points + 2) : letters;
            Refinement refinement(curve_of(system, {2, ends, word, 1, std::vector<double>(points, 1.0)}));
            const Curve start = refinement.curve();
            for (std::uint64_t step = 1; step <= 12; ++step) {
                const RefinementSize size = refined_size(start, step, max_predicted);
                if (size.exceeded) break;
                refinement.step();
                EXPECT_EQ(size.points, refinement.curve().size()) << name << " step " << step;
            }
        }
    }
}

TEST(Refinement, RefusesToCountForEver) {
    const Curve curve = curve_of(fibonacci(), {2, Ends::Circular, {a, b}, 1, {0, 1}});
    const RefinementSize size = refined_size(curve, 1'000'000'000, 100'000'000);
    EXPECT_TRUE(size.exceeded);
    EXPECT_GT(size.points, 100'000'000u);
    EXPECT_TRUE(refined_size(curve, 0, 1).exceeded);
    EXPECT_FALSE(refined_size(curve, 0, 2).exceeded);
    EXPECT_TRUE(refined_size(curve, 1, 2).exceeded);
    EXPECT_FALSE(refined_size(curve, ~std::uint64_t{0}, ~std::uint64_t{0}).points == 0);
}

TEST(Refinement, SaysTheBytesOfItsLastStep) {
    const Curve curve = curve_of(fibonacci(), {2, Ends::Circular, {a, b}, 3, std::vector<double>(6)});
    // 2 points, then 3, then 5; each 3 coordinates, a letter and a state.
    EXPECT_EQ(refined_size(curve, 0, 100).bytes, 2u * 32);
    EXPECT_EQ(refined_size(curve, 2, 100).bytes, (3u + 5) * 32);
}

TEST(Refinement, KeepsTheStatesOfItsCells) {
    for_random_curves(6, repetitions, [](const Curve& curve, Random&) {
        Refinement refinement(curve);
        for (int step = 0; step < 3; ++step) {
            const auto cells = cell_states(refinement.curve().word(), curve.degree(), curve.ends());
            ASSERT_EQ(cells.size(), refinement.states().size());
            for (std::size_t i = 0; i < cells.size(); ++i)
                ASSERT_EQ(refinement.automaton().state(refinement.states()[i]), cells[i]) << "cell " << i;
            refinement.step();
        }
    });
}

TEST(Refinement, OfOneClosedPointStaysThere) {
    for (int degree = 1; degree <= 6; ++degree) {
        const Curve fine = refine(curve_of(fibonacci(), {degree, Ends::Circular, {a}, 2, {3, -5}}), 6);
        EXPECT_EQ(fine.size(), 21u);
        for (std::size_t i = 0; i < fine.size(); ++i) {
            EXPECT_NEAR(fine.points()[2 * i], 3, 1e-14);
            EXPECT_NEAR(fine.points()[2 * i + 1], -5, 1e-14);
        }
    }
}

TEST(Refinement, WrapsShortClosedWordsLikeTheirRepetition) {
    Random random(7);
    for (int degree = 1; degree <= 6; ++degree)
        for (const std::size_t letters : {1u, 2u, 3u}) {
            const Curve once = random_curve(random, fibonacci(), degree, Shape::Closed, letters, 2);
            CurveData data{degree, Ends::Circular, repeated(once.word(), 12 * letters), 2, {}};
            for (int turn = 0; turn < 12; ++turn)
                data.points.insert(data.points.end(), once.points().begin(), once.points().end());
            const Curve fine = refine(once, 3);
            const Curve many = refine(curve_of(fibonacci(), data), 3);
            ASSERT_EQ(many.size(), 12 * fine.size());
            for (std::size_t i = 0; i < many.points().size(); ++i)
                EXPECT_EQ(many.points()[i], fine.points()[i % fine.points().size()]);
        }
}

TEST(Refinement, CommutesWithAffineMaps) {
    for_random_curves(8, repetitions, [](const Curve& curve, Random& random) {
        const std::size_t dimension = curve.dimension();
        std::vector<double> matrix(dimension * dimension);
        std::vector<double> shift(dimension);
        for (double& entry : matrix) entry = random.coordinate();
        for (double& entry : shift) entry = random.coordinate();
        const auto mapped = [&](const std::vector<double>& points) {
            std::vector<double> result(points.size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::size_t row = i / dimension * dimension;
                result[i] = shift[i % dimension];
                for (std::size_t c = 0; c < dimension; ++c)
                    result[i] += matrix[i % dimension * dimension + c] * points[row + c];
            }
            return result;
        };
        const Curve image =
            curve_of(curve.system(), {curve.degree(), curve.ends(), curve.word(), dimension, mapped(curve.points())});
        const std::vector<double> left = mapped(refine(curve, 2).points());
        const std::vector<double> right = refine(image, 2).points();
        for (std::size_t i = 0; i < left.size(); ++i) EXPECT_NEAR(left[i], right[i], 1e-13);
    });
}

TEST(Refinement, ReproducesGrevilleAbscissae) {
    for_random_curves(9, repetitions, [](const Curve& curve, Random&) {
        if (curve.ends() == Ends::Circular) return;
        const Curve line =
            curve_of(curve.system(), {curve.degree(), curve.ends(), curve.word(), 1, greville_abscissae(curve)});
        const Curve fine = refine(line, 2);
        const std::vector<double> expected = greville_abscissae(fine);
        for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine.points()[i], expected[i], 1e-12);
    });
}

TEST(Refinement, TwoStepsAreOneStepOfTheSquare) {
    for (const auto& rules : std::vector<std::vector<std::string>>{{"BA", "A"}, {"AAB", "A"}, {"AB", "AC", "A"}}) {
        const IntervalSystem system = system_with(rules);
        const Verdict squared = validate(tests::grammar_of(power(system.rules(), 2)));
        ASSERT_TRUE(squared.system.has_value());
        Random random(10);
        const int highest = system.field().degree() > 2 || repetitions == 1 ? 3 : 6;
        for (int degree = 1; degree <= highest; ++degree)
            for (const Shape shape : all_shapes) {
                const Curve curve = random_curve(random, system, degree, shape, 4, 2);
                const Curve other = curve_of(*squared.system, {degree, curve.ends(), curve.word(), 2, curve.points()});
                const Curve twice = refine(curve, 2);
                const Curve once = refine(other, 1);
                ASSERT_EQ(once.word(), twice.word());
                for (std::size_t i = 0; i < once.points().size(); ++i)
                    EXPECT_NEAR(once.points()[i], twice.points()[i], 1e-14);
            }
    }
}

TEST(Refinement, ClampedEndsStayExactly) {
    for_random_curves(11, repetitions, [](const Curve& curve, Random&) {
        if (curve.word().front() != o || curve.word().back() != o) return;
        const auto d = static_cast<std::ptrdiff_t>(curve.degree());
        if (std::count(curve.word().begin(), curve.word().begin() + d, o) != d) return;
        if (std::count(curve.word().end() - d, curve.word().end(), o) != d) return;
        const std::vector<double>& points = curve.points();
        const Curve fine = refine(curve, 4);
        for (std::size_t c = 0; c < curve.dimension(); ++c) {
            EXPECT_EQ(fine.points()[c], points[c]);
            const std::size_t back = c + 1;
            EXPECT_EQ(fine.points()[fine.points().size() - back], points[points.size() - back]);
        }
    });
}

TEST(Refinement, NothingCrossesABreak) {
    // d = 2: A B 0 0 A A; moving the points right of the break leaves the left part as it is.
    const Word word = clamped(Word{a, b, o, o, a, a}, 2);
    std::vector<double> points{0, 1, 0, 2, 5, 6, 5, 7};
    const Curve before = refine(curve_of(fibonacci(), {2, Ends::Open, word, 1, points}), 3);
    for (std::size_t i = 4; i < points.size(); ++i) points[i] += 100;
    const Curve after = refine(curve_of(fibonacci(), {2, Ends::Open, word, 1, points}), 3);
    bool right = false;
    for (std::size_t i = 0; i < before.size(); ++i) {
        right = right || before.points()[i] > 4;
        EXPECT_NEAR(after.points()[i] - before.points()[i], right ? 100 : 0, 1e-12);
    }
}

TEST(Refinement, NoStepsChangeNothingAndNegativeStepsAreRefused) {
    const Curve curve = curve_of(fibonacci(), {2, Ends::Circular, {a, b}, 1, {0, 1}});
    EXPECT_EQ(refine(curve, 0).points(), curve.points());
    EXPECT_THROW((void)refine(curve, -1), std::invalid_argument);
}

TEST(Refinement, HasALimitOfStates) {
    const Curve curve = curve_of(fibonacci(), {3, Ends::Circular, {a, b, a, a, b}, 1, {0, 1, 2, 3, 4}});
    EXPECT_THROW(Refinement(curve, 3), TooManyStates);
}

} // namespace
} // namespace internode
