// SPDX-License-Identifier: MIT

#include "internode/report/text/validation_text.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::HasSubstr;
using testing_report::grammar_of;

std::string text_of(const IntervalGrammar& grammar, const ValidityLimits& limits = {}) {
    return validation_text(validate(grammar, limits), grammar);
}

TEST(ValidationText, SaysWhatFibonacciIs) {
    const std::string text = text_of(grammar_of(testing_report::fibonacci));
    EXPECT_THAT(text, HasSubstr("fibonacci: valid\n"));
    EXPECT_THAT(text, HasSubstr("φ ≈ 1.618033988749895, the largest root of x² − x − 1"));
    EXPECT_THAT(text, HasSubstr("theorem 3.7 and corollary 3.8 of Nivoliers et al. 2012"));
    EXPECT_THAT(text, HasSubstr("2−φ ≈ 0.382"));
}

TEST(ValidationText, GivesTheReasonFirst) {
    EXPECT_THAT(text_of(grammar_of("A1 -> A1 A1 A2\nA2 -> A2")),
                HasSubstr("The system is not valid\n  - class {A2} never splits"));
}

TEST(ValidationText, SpeaksOfEnclosuresWithoutAField) {
    const std::string text = text_of(grammar_of(testing_report::slow_growth), {.exact_class = 200, .field_degree = 2});
    EXPECT_THAT(text, HasSubstr("ρ ≈ 1.25992104989487"));
    EXPECT_THAT(text, HasSubstr("enclosure"));
}

TEST(ValidationText, SaysWhichSymbolsNeverOccurAndWhereFrequenciesAreMissing) {
    EXPECT_THAT(text_of(grammar_of("A -> A A\nB -> A B\naxiom (A A)")), HasSubstr("the axiom never produces it"));
    EXPECT_THAT(text_of(grammar_of("A -> A A\nB -> B B")), HasSubstr("Frequencies depend on the axiom"));
}

TEST(ValidationText, ShowsNamesWithoutObeyingThem) {
    const std::string text = text_of(testing_report::hostile_grammar());
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
}

} // namespace
} // namespace internode
