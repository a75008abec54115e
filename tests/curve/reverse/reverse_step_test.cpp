// SPDX-License-Identifier: MIT
//
// Steps backwards: A P = I, f = P c + Q e, and one detail per inserted knot, over all small grammars.

#include "internode/curve/reverse/reverse_step.h"

#include "internode/curve/refinement.h"
#include "internode/stencil/step_matrix.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/numbers.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>

namespace internode {
namespace {

using tests::largest_difference;
using tests::Random;
using tests::random_numbers;
using tests::Shape;
using tests::system_of;
using tests::word_of;

const std::size_t stride = tests::stride();

Knots knots_of(const IntervalSystem& system, KnotsData data) {
    CheckedKnots checked = make_knots(system, std::move(data));
    if (!checked.knots) throw std::logic_error("the knots do not fit: " + checked.problems.front());
    return *checked.knots;
}

double largest(std::span<const double> numbers) {
    double most = 0;
    for (const double number : numbers) most = std::max(most, std::abs(number));
    return most;
}

/// Every valid grammar of at most 2 symbols and rules of at most 3 letters, with every degree, closed and clamped words
/// of a few lengths; each by both methods.
void for_small_steps(const std::function<void(const Hierarchy&, const ReverseOptions&, Random&)>& check) {
    Random random(7);
    std::size_t count = 0;
    tests::Compared compared;
    for (const IntervalGrammar& grammar : tests::small_grammars(2, 3)) {
        const Verdict verdict = validate(grammar);
        if (!verdict.system || count++ % stride != 0) continue;
        for (int degree = 1; degree <= 5; ++degree)
            for (const std::size_t letters : {1U, 2U, 3U, 5U, 12U})
                for (const Ends ends : {Ends::Circular, Ends::Open}) {
                    Word word(letters);
                    for (Symbol& letter : word) letter = to_symbol(random.below(grammar.alphabet.size()));
                    if (ends == Ends::Open) word = clamped(word, degree);
                    const Hierarchy hierarchy(knots_of(*verdict.system, {degree, ends, word}), 2);
                    for (const ReverseMethod method : {ReverseMethod::LeastSquares, ReverseMethod::Local})
                        check(hierarchy, {method, 5}, random), ++compared;
                }
    }
}

std::string name_of(const Hierarchy& hierarchy, const ReverseOptions& options) {
    std::string text = "degree " + std::to_string(hierarchy.coarse().degree());
    text += options.method == ReverseMethod::Local ? " local " : " least squares ";
    text += hierarchy.coarse().ends() == Ends::Circular ? "closed " : "clamped ";
    const Alphabet& alphabet = hierarchy.coarse().system().alphabet();
    text += to_string(hierarchy.coarse().word(), alphabet) + " under";
    for (const Word& image : hierarchy.coarse().system().rules().images()) text += " " + to_string(image, alphabet);
    return text;
}

TEST(Hierarchy, HasTheMatricesOfItsSteps) {
    for_small_steps([](const Hierarchy& hierarchy, const ReverseOptions& options, Random& random) {
        if (options.method == ReverseMethod::Local) return;
        const Knots& knots = hierarchy.coarse();
        const std::vector<double> points = random_numbers(random, knots.size());
        const CheckedCurve curve = make_curve(knots, 1, points);
        const Curve fine = refine(*curve.curve, 2);
        const std::vector<double> middle = product(hierarchy.matrix(0), points, 1);
        ASSERT_EQ(hierarchy.size(2), fine.size());
        EXPECT_LT(largest_difference(product(hierarchy.matrix(1), middle, 1), fine.points()), 1e-14);
    });
}

TEST(ReverseStep, UndoesRefinement) {
    for_small_steps([](const Hierarchy& hierarchy, const ReverseOptions& options, Random& random) {
        for (int level = 0; level < 2; ++level) {
            const ReverseStep step(hierarchy, level, options);
            const std::vector<double> coarse = random_numbers(random, 2 * step.coarse_size());
            const std::vector<double> fine = product(hierarchy.matrix(level), coarse, 2);
            EXPECT_LT(largest_difference(step.coarse(fine, 2), coarse), 1e-12) << name_of(hierarchy, options);
            EXPECT_LT(largest(step.details(fine, coarse, 2).vectors), 1e-12) << name_of(hierarchy, options);
        }
    });
}

TEST(ReverseStep, GivesTheFinePolygonBack) {
    for_small_steps([](const Hierarchy& hierarchy, const ReverseOptions& options, Random& random) {
        for (int level = 0; level < 2; ++level) {
            const ReverseStep step(hierarchy, level, options);
            const std::vector<double> fine = random_numbers(random, 2 * step.fine_size());
            const std::vector<double> coarse = step.coarse(fine, 2);
            const Details details = step.details(fine, coarse, 2);
            EXPECT_LT(largest_difference(step.fine(coarse, details, 2), fine), 1e-12) << name_of(hierarchy, options);
            EXPECT_LT(largest(details.vectors), 40) << name_of(hierarchy, options);
        }
    });
}

TEST(ReverseStep, HasOneDetailPerInsertedKnot) {
    for_small_steps([](const Hierarchy& hierarchy, const ReverseOptions& options, Random&) {
        for (int level = 0; level < 2; ++level) {
            const ReverseStep step(hierarchy, level, options);
            EXPECT_EQ(step.inserted().size(), hierarchy.size(level + 1) - hierarchy.size(level));
            EXPECT_TRUE(std::ranges::is_sorted(step.inserted()));
        }
    });
}

} // namespace
} // namespace internode
