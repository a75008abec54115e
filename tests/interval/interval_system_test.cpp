// SPDX-License-Identifier: MIT

#include "internode/interval/interval_system.h"

#include "internode/interval/validity.h"
#include "tests/fixtures/interval_grammars.h"
#include "tests/fixtures/interval_systems.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace internode {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;
using tests::fibonacci_grammar;
using tests::make_grammar;
using tests::slow_growth;
using tests::system_of;
using tests::with_length;

TEST(IntervalSystem, TheZeroIntervalHasLengthZero) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    EXPECT_EQ(system.length(zero_interval), Number(0));
    EXPECT_FALSE(system.occurs(zero_interval));
    EXPECT_EQ(system.length(Symbol{0}), system.ratio());
    EXPECT_THROW((void)system.length(Symbol{2}), std::out_of_range);
}

TEST(IntervalSystem, OnlyTheGoldenRatioHasItsOwnName) {
    EXPECT_EQ(system_of(fibonacci_grammar()).ratio_name(), "φ");
    EXPECT_EQ(system_of(slow_growth(2)).ratio_name(), "ρ");
}

TEST(IntervalSystem, BisectionKeepsLengthsAndField) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    const IntervalSystem halves = bisection(system);
    EXPECT_EQ(halves.lengths(), system.lengths());
    EXPECT_EQ(halves.field(), system.field());
    EXPECT_EQ(halves.ratio(), Number(2));
    EXPECT_EQ(halves.rules().images()[1], (Word{Symbol{1}, Symbol{1}}));
    EXPECT_EQ(halves.period(), 1U);
    EXPECT_THAT(with_lengths(halves, {{Symbol{1}, 7}}).system.value().lengths(),
                ElementsAre(system.ratio(), Number(7)));
}

TEST(IntervalSystem, APowerKeepsLengthsAndFieldAndSatisfiesItsOwnEquation) {
    for (const IntervalGrammar& grammar :
         {fibonacci_grammar(), slow_growth(3), make_grammar({{"A", "A B"}, {"B", "B B B"}}),
          with_length(make_grammar({{"A", "A A"}, {"B", "B B"}}), "B", 5)}) {
        const IntervalSystem system = system_of(grammar);
        for (int steps = 1; steps <= 6; ++steps) {
            const IntervalSystem several = power(system, steps);
            EXPECT_EQ(several.lengths(), system.lengths());
            EXPECT_EQ(several.field(), system.field());
            EXPECT_EQ(several.ratio(), pow(system.ratio(), steps));
            for (std::size_t i = 0; i < several.lengths().size(); ++i) {
                Number sum;
                for (const Symbol letter : several.rules().image(to_symbol(i))) sum += several.length(letter);
                EXPECT_EQ(several.ratio() * several.lengths()[i], sum);
            }
        }
    }
}

TEST(IntervalSystem, APowerHasThePeriodAndTheNameOfItsSteps) {
    const IntervalSystem slow = system_of(slow_growth(6));
    ASSERT_EQ(slow.period(), 6U);
    for (const int steps : {1, 2, 3, 4, 5, 6}) {
        const IntervalSystem several = power(slow, steps);
        EXPECT_EQ(several.period(), system_of(several.grammar()).period()) << steps;
    }
    IntervalGrammar named = fibonacci_grammar();
    named.name = "fibonacci";
    EXPECT_EQ(power(system_of(named), 1).grammar().name, "fibonacci");
    EXPECT_EQ(power(system_of(named), 3).grammar().name, "fibonacci^3");
}

TEST(IntervalSystem, APowerIsAtLeastOneAndWithinTheLimit) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    EXPECT_THROW((void)power(system, 0), std::invalid_argument);
    EXPECT_THROW((void)power(system, 60), std::length_error);
    EXPECT_THROW((void)power(system, 2'000'000'000), std::length_error);
}

TEST(IntervalSystem, LengthsAreGivenBeforeAPowerIsTaken) {
    // A leads to two final classes: its length follows from theirs, which a power of the ratio would get wrong.
    const IntervalSystem system = system_of("B->BB, C->CC, A->BC");
    const std::vector<FixedLength> given{{Symbol{1}, 1}};
    const IntervalSystem fixed = with_lengths(system, given).system.value();
    EXPECT_EQ(power(fixed, 2).lengths(), fixed.lengths());
    EXPECT_THROW((void)with_lengths(power(system, 2), given), std::invalid_argument);
    EXPECT_TRUE(with_lengths(power(system, 1), given).system);
}

TEST(IntervalSystem, AGivenLengthScalesTheOthers) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    const FixedLengths fixed = with_lengths(system, {{Symbol{1}, Number(Rational(1, 2))}});
    ASSERT_TRUE(fixed.system);
    EXPECT_THAT(fixed.system->lengths(), ElementsAre(system.ratio() / 2, Number(Rational(1, 2))));
    EXPECT_THAT(fixed.system->grammar().lengths, SizeIs(1));
    const FixedLengths again = with_lengths(*fixed.system, {{Symbol{0}, 3}});
    EXPECT_THAT(again.system->grammar().lengths, ElementsAre(LengthDeclaration{Symbol{0}, 3}))
        << "the old declaration no longer holds";
}

TEST(IntervalSystem, AGivenLengthMayLieInTheField) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    const Number phi = system.ratio();
    const FixedLengths fixed = with_lengths(system, {{Symbol{0}, 1 / phi}, {Symbol{1}, 1 / (phi * phi)}});
    ASSERT_TRUE(fixed.system);
    EXPECT_THAT(fixed.system->lengths(), ElementsAre(1 / phi, 1 / (phi * phi)));
    EXPECT_THAT(fixed.system->grammar().lengths, SizeIs(0)) << "a grammar can only say rational ones";
    const Number other = NumberField({-2, 0, 1}, 1, 2).generator();
    EXPECT_THROW((void)with_lengths(system, {{Symbol{0}, other}}), std::invalid_argument);
}

TEST(IntervalSystem, GivenLengthsThatDisagreeAreReportedWithBothNumbers) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    const FixedLengths fixed = with_lengths(system, {{Symbol{1}, 1}, {Symbol{0}, 2}});
    EXPECT_FALSE(fixed.system);
    ASSERT_THAT(fixed.conflicts, SizeIs(1));
    EXPECT_EQ(fixed.conflicts[0].symbol, Symbol{0});
    EXPECT_EQ(fixed.conflicts[0].given, Number(2));
    EXPECT_EQ(fixed.conflicts[0].implied, system.ratio());
    EXPECT_THROW((void)with_lengths(system, {{Symbol{1}, 0}}), std::invalid_argument);
    EXPECT_THROW((void)with_lengths(system, {{Symbol{9}, 1}}), std::out_of_range);
}

TEST(IntervalSystem, SharedSymbolsFollowTheScalesOfTheirFinalClasses) {
    const IntervalSystem system = system_of(make_grammar({{"P", "P B C"}, {"B", "B B B"}, {"C", "C C C"}}));
    const FixedLengths fixed = with_lengths(system, {{Symbol{1}, 3}, {Symbol{2}, 5}});
    ASSERT_TRUE(fixed.system);
    EXPECT_THAT(fixed.system->lengths(), ElementsAre(Number(4), Number(3), Number(5))) << "3 P = P + B + C";
}

TEST(IntervalSystem, AOneSymbolRuleServesManyLengths) {
    const IntervalSystem system = system_of(make_grammar({{"A", "A A A"}}));
    const IntervalSystem many = one_symbol_a_length(system, {"A1", "A2"}, {Rational(1, 3), 5});
    EXPECT_THAT(many.lengths(), ElementsAre(Number(Rational(1, 3)), Number(5)));
    EXPECT_EQ(many.rules(), Morphism({Word(3, Symbol{0}), Word(3, Symbol{1})}));
    EXPECT_EQ(many.ratio(), Number(3));
    const Verdict verdict = validate(many.grammar());
    ASSERT_TRUE(verdict.system);
    EXPECT_EQ(verdict.system->lengths(), many.lengths());
    EXPECT_THROW((void)one_symbol_a_length(many, {"A"}, {1}), std::invalid_argument);
    EXPECT_THROW((void)one_symbol_a_length(system, {}, {}), std::invalid_argument);
    EXPECT_THROW((void)one_symbol_a_length(system, {"A"}, {1, 2}), std::invalid_argument);
    EXPECT_THROW((void)one_symbol_a_length(system, {"A", "A"}, {1, 2}), std::invalid_argument);
    EXPECT_THROW((void)one_symbol_a_length(system, {"A"}, {0}), std::invalid_argument);
}

} // namespace
} // namespace internode
