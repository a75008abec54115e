// SPDX-License-Identifier: MIT

#include "internode/point/infer/production.h"

#include "internode/algebra/fraction.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "internode/io/file/input_file.h"
#include "internode/point/infer/inference.h"
#include "internode/point/infer/reverse_rules.h"
#include "tests/fixtures/point_systems.h"
#include "tests/fixtures/source_folder.h"
#include "tests/reference/point_rows.h"

#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::HasSubstr;

std::string text_of(const PointProduction& production) {
    return print(to_grammar("g",
                            production.after_marker || production.before_marker ? WordEnds::Markers : WordEnds::Ring,
                            std::span(&production, 1)));
}

TEST(Production, TakesTheShortestContexts) {
    EXPECT_EQ(with_shortest_contexts(1, {{{0, 1}}}), (PointProduction{0, 1, 0, false, false, {{{0, 1}}}}));
    EXPECT_EQ(with_shortest_contexts(1, {}), (PointProduction{0, 1, 0, false, false, {}}));
    EXPECT_EQ(with_shortest_contexts(2, {{}, {{-3, 1}, {4, 1}}}).left, 3U);
    EXPECT_EQ(with_shortest_contexts(2, {{}, {{-3, 1}, {4, 1}}}).right, 3U);
    EXPECT_EQ(with_shortest_contexts(1, {{{2, 1}}}).left, 0U);
}

TEST(Production, IsWrittenAsThePapersWrite) {
    EXPECT_THAT(
        text_of(
            {1,
             1,
             2,
             false,
             false,
             {{{0, 1}}, {{-1, fraction(-1, 16)}, {0, fraction(9, 16)}, {1, fraction(9, 16)}, {2, fraction(-1, 16)}}}}),
        HasSubstr("P(v_l) < P(v) > P(v_r) P(v_rr) -> P(v) P(-1/16 v_l + 9/16 v + 9/16 v_r - 1/16 v_rr)\n"));
    EXPECT_THAT(text_of({1,
                         2,
                         1,
                         false,
                         false,
                         {{{-1, fraction(-1, 4)}, {0, fraction(3, 4)}, {1, fraction(3, 4)}, {2, fraction(-1, 4)}}}}),
                HasSubstr("P(v_l) < P(v_a) P(v_b) > P(v_r) -> P(-1/4 v_l + 3/4 v_a + 3/4 v_b - 1/4 v_r)\n"));
    EXPECT_THAT(text_of({1, 1, 0, true, false, {{{-1, -1}, {0, 2}}}}), HasSubstr("# P(v_l) < P(v) -> P(-v_l + 2 v)\n"));
    EXPECT_THAT(text_of({4, 1, 0, false, false, {{{-4, 1}}}}),
                HasSubstr("P(v_l4) P(v_lll) P(v_ll) P(v_l) < P(v) -> P(v_l4)"));
    EXPECT_THAT(text_of({0, 1, 0, false, false, {{}}}), HasSubstr("P(v) -> P(0 v)\n"));
    EXPECT_THAT(text_of({0, 12, 0, false, false, {{{11, 1}}}}), HasSubstr("P(v_12) -> P(v_12)\n"));
}

TEST(Production, GrammarsAreReadBackAsTheyAre) {
    const std::vector<PointProduction> productions{
        {1, 1, 1, true, false, {{{-1, fraction(-1, 2)}, {0, -1}, {1, fraction(-5, 2)}}}},
        {1, 1, 1, false, true, {{{-1, -1}, {0, fraction(1, 3)}}, {{1, 1}}}},
        {5, 1, 4, false, false, {{{-5, 1}, {4, fraction(-1, 7)}}, {}}},
        {0, 3, 1, false, false, {{{0, 1}, {3, 1}}}},
        {0, 1, 0, false, true, {}},
        {0, 1, 0, false, false, {{{0, 1}}}}};
    for (const WordEnds ends : {WordEnds::Markers, WordEnds::KeptMarkers}) {
        const PointGrammar grammar = to_grammar("some name", ends, productions);
        const ParsedPointGrammar parsed = parse_point_grammar(print(grammar), "printed");
        ASSERT_TRUE(parsed.grammar) << to_string(parsed.errors);
        EXPECT_EQ(*parsed.grammar, grammar) << print(grammar);
    }
    for (const PointProduction& production : productions) {
        if (production.after_marker || production.before_marker) continue;
        const PointGrammar grammar = to_grammar("g", WordEnds::Ring, std::span(&production, 1));
        EXPECT_EQ(parse_point_grammar(print(grammar), "printed").grammar, grammar);
    }
}

TEST(Production, RefusesOffsetsBeyondItsContextsAndMarkersInARing) {
    const PointProduction far{0, 1, 0, false, false, {{{1, 1}}}};
    EXPECT_THROW((void)to_grammar("g", WordEnds::Ring, std::span(&far, 1)), std::invalid_argument);
    const PointProduction before{1, 1, 0, false, false, {{{-2, 1}}}};
    EXPECT_THROW((void)to_grammar("g", WordEnds::Ring, std::span(&before, 1)), std::invalid_argument);
    const PointProduction marked{0, 1, 0, true, false, {{{0, 1}}}};
    EXPECT_THROW((void)to_grammar("g", WordEnds::Ring, std::span(&marked, 1)), std::invalid_argument);
}

PointGrammar bundled(const std::string& name) {
    return tests::point_grammar(tests::text_of_data(name));
}

/// The production of that shift in the grammar's own matrix.
std::string inferred_text(const PointGrammar& grammar, std::ptrdiff_t shift) {
    const InferredPattern inferred = infer_closed(tests::row_matrix(grammar, 9));
    return print(closed_grammar(grammar.name, production_of(inferred.pattern.value(), shift)));
}

TEST(Inference, OfTheMatrixOfAGrammarIsTheGrammar) {
    for (const char* name : {"s0/13", "s0/17", "s0/18", "s0/20", "s0/22", "s0/23", "s0/25", "s0/26"}) {
        const PointGrammar grammar = bundled(name);
        EXPECT_EQ(inferred_text(grammar, 0), print(grammar));
    }
}

TEST(Inference, OfTheOpenMatrixOfAGrammarIsTheGrammarInBothForms) {
    const RationalMatrix matrix = tests::row_matrix(bundled("s0/28-33"), 9);
    EXPECT_EQ(matrix, tests::row_matrix(bundled("s0/34-36"), 9));
    const OpenPattern pattern = infer_open(matrix).pattern.value();
    const OpenProductions productions =
        open_productions(pattern, sensible_open_shifts(pattern).recommended).productions.value();
    EXPECT_EQ(print(open_grammar("s0/28-33", productions, OpenForm::Long)), print(bundled("s0/28-33")));
    EXPECT_EQ(print(open_grammar("s0/34-36", productions, OpenForm::Ordered)), print(bundled("s0/34-36")));
}

TEST(ReverseRules, OfChaikinAreThePapersText) {
    const UniformMask chaikin{2, -1, {fraction(1, 4), fraction(3, 4), fraction(3, 4), fraction(1, 4)}};
    EXPECT_EQ(print(reverse_grammar("s0/38", reverse_rule(chaikin).value())), print(bundled("s0/38")));
}

} // namespace
} // namespace internode
