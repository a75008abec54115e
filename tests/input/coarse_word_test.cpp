// SPDX-License-Identifier: MIT
//
// coarser_word is the inverse of refined_word, up to letters that no fine letter shows.

#include "internode/input/coarse_word.h"

#include "internode/curve/refinement.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using tests::Random;
using tests::random_curve;
using tests::Shape;
using tests::system_of;
using tests::word_of;

TEST(CoarserWord, RefinesToTheWordItCameFrom) {
    Random random(7);
    std::size_t compared = 0;
    for (const char* const rules : {"L->SL, S->L", "A->AAA, B->BBB", "A->AB, B->BBB"})
        for (const Shape shape : {Shape::Open, Shape::Closed, Shape::Clamped, Shape::ClampedWithZeros})
            for (const int degree : {1, 2, 3}) {
                const IntervalSystem system = system_of(rules);
                const Curve curve = random_curve(random, system, degree, shape, 6, 1);
                const Word fine = refined_word(system.rules(), curve.word(), degree, curve.ends());
                const std::optional<Word> coarse = coarser_word(system.rules(), fine, degree, curve.ends());
                ASSERT_TRUE(coarse) << rules;
                EXPECT_EQ(refined_word(system.rules(), *coarse, degree, curve.ends()), fine) << rules;
                ++compared;
            }
    EXPECT_EQ(compared, 36U);
}

TEST(CoarserWord, IsNoneWhereNothingWasRefined) {
    const IntervalSystem system = system_of("A->AA, B->BB");
    EXPECT_FALSE(coarser_word(system.rules(), word_of(system, "AAB"), 2, Ends::Circular));
    EXPECT_FALSE(coarser_word(system.rules(), word_of(system, "00AAB00"), 2, Ends::Open));
    EXPECT_EQ(coarser_word(system.rules(), word_of(system, "00AABB00"), 2, Ends::Open).value(),
              word_of(system, "00AB00"));
}

} // namespace
} // namespace internode
