// SPDX-License-Identifier: MIT

#include "internode/report/automaton_export.h"

#include "internode/curve/knots.h"
#include "internode/report/code/automaton_code.h"
#include "internode/report/json/automaton_json.h"
#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/report/systems.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace internode {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using tests::system_of;

const Generator maker{"0.1.0", "internode masks"};

AutomatonExport persistent(const std::string& grammar, int degree) {
    return export_automaton("g", system_of(grammar), degree, WordChoice::Default, max_states);
}

TEST(AutomatonExport, ServesEveryOpenAndClampedWordThatPersists) {
    for (const auto& [name, text] : tests::sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem system = system_of(text);
        for (int degree = 1; degree <= 3; ++degree) {
            const AutomatonExport exported = persistent(text, degree);
            EXPECT_EQ(exported.start, "persistent");
            const auto d = static_cast<std::size_t>(degree);
            for (const Word& word : persistent_words(system.rules(), 2 * d + 2, 100'000)) {
                for (const CellState& cell : cell_states(word, degree, Ends::Open))
                    EXPECT_NO_THROW((void)exported.automaton.find(cell));
                for (const CellState& cell : cell_states(clamped(word, degree), degree, Ends::Open))
                    EXPECT_NO_THROW((void)exported.automaton.find(cell));
            }
        }
    }
}

TEST(AutomatonExport, OfAWordHoldsItsCellsAndNoOther) {
    const IntervalSystem fibonacci_system = system_of("L->SL, S->L");
    const Axiom word{tests::word_of(fibonacci_system, "SSSSS"), Ends::Circular};
    const AutomatonExport exported = export_automaton("g", fibonacci_system, 3, word, max_states);
    EXPECT_EQ(exported.start, "word");
    EXPECT_EQ(exported.automaton.state_count(), 9U);
    EXPECT_EQ(persistent("L->SL, S->L; axiom (SSSSS)", 3).automaton.state_count(), 9U);
    EXPECT_EQ(persistent("L->SL, S->L; axiom (SSSSS)", 3).start, "axiom");
}

TEST(AutomatonExport, RefusesWhatIsNone) {
    const IntervalSystem fibonacci_system = system_of("L->SL, S->L");
    const auto make = [&](int degree, WordChoice choice, std::size_t limit) {
        return export_automaton("g", fibonacci_system, degree, choice, limit);
    };
    EXPECT_THROW((void)make(0, WordChoice::Default, max_states), std::invalid_argument);
    EXPECT_THROW((void)make(13, WordChoice::Default, max_states), std::invalid_argument);
    EXPECT_THROW((void)make(2, WordChoice::Reachable, max_states), std::invalid_argument);
    EXPECT_THROW((void)make(2, WordChoice::Persistent, 10), TooManyStates);
    EXPECT_THROW((void)make(5, WordChoice::All, 10), TooManyWords);
    const Axiom word{tests::word_of(fibonacci_system, "LS"), Ends::Open};
    EXPECT_THROW((void)export_automaton("g", fibonacci_system, 2, word, max_states), std::invalid_argument);
    EXPECT_THROW((void)cells_of_windows({}, 0), std::invalid_argument);
}

TEST(AutomatonJson, SaysStatesChildrenAndRows) {
    const AutomatonExport exported = persistent("L->SL, S->L", 2);
    const json document = json::parse(automaton_json(exported, maker));
    EXPECT_EQ(document["format"], "internode-automaton");
    EXPECT_EQ(document["version"], 1);
    EXPECT_EQ(document["degree"], 2);
    EXPECT_EQ(document["start"], "persistent");
    ASSERT_EQ(document["states"].size(), exported.automaton.state_count());
    ASSERT_EQ(document["rows"].size(), exported.automaton.row_count());
    for (std::uint32_t s = 0; s < exported.automaton.state_count(); ++s) {
        const json& state = document["states"][s];
        EXPECT_EQ(state["window"].size(), 3U);
        EXPECT_EQ(state["lead"], exported.automaton.state(s).lead);
        EXPECT_EQ(state["offset"], exported.automaton.offset(s));
        ASSERT_EQ(state["children"].size(), exported.automaton.children(s).size());
        for (const json& child : state["children"]) {
            EXPECT_LT(child["state"].get<std::size_t>(), document["states"].size());
            EXPECT_LT(child["row"].get<std::size_t>(), document["rows"].size());
        }
    }
    for (std::uint32_t row = 0; row < exported.automaton.row_count(); ++row)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(document["rows"][row][i]["value"], exported.automaton.weights(row)[i]);
}

TEST(AutomatonJson, NamesAreInert) {
    const IntervalSystem system = validate(testing_report::hostile_grammar()).system.value();
    testing_report::expect_inert(
        automaton_json(export_automaton(testing_report::hostile, system, 2, WordChoice::Default, max_states),
                       {"0", testing_report::hostile}));
}

/// The text without its block comments; a comment that does not end takes everything.
std::string without_comments(const std::string& text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const auto begin = text.find("/*", at);
        code += text.substr(at, begin - at);
        if (begin == std::string::npos) break;
        const auto end = text.find("*/", begin + 2);
        at = end == std::string::npos ? text.size() : end + 2;
    }
    return code;
}

TEST(AutomatonCode, KeepsTheUsersTextInsideItsComments) {
    const IntervalSystem system = validate(testing_report::hostile_grammar()).system.value();
    const std::string evil = testing_report::hostile + "*/ int evil; /* /*/ \\\n \?\?/\n";
    AutomatonExport exported = export_automaton("good", system, 2, WordChoice::Default, max_states);
    const std::string c = without_comments(automaton_c(exported, {"0", "good"}));
    const std::string glsl = without_comments(automaton_glsl(exported, {"0", "good"}));
    const std::string name = code_identifier(evil);
    exported.name = evil;
    const auto renamed = [&](std::string text) {
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at))
            text.replace(at, name.size(), "good");
        return text;
    };
    for (const std::string& text : {automaton_c(exported, {evil, evil}), automaton_glsl(exported, {evil, evil})}) {
        for (const char* bad : {"\x1b", "\xE2\x80\xAE", "\xFF", "\\\n", "\\N"})
            EXPECT_EQ(text.find(bad), std::string::npos) << bad;
        const std::string code = renamed(without_comments(text));
        EXPECT_TRUE(code == c || code == glsl) << code;
    }
    EXPECT_THAT(c, HasSubstr("good_2_weights"));
}

TEST(AutomatonCode, MakesIdentifiersOfNames) {
    EXPECT_EQ(code_identifier("fibonacci"), "fibonacci");
    EXPECT_EQ(code_identifier("slow-growth-4"), "slow_growth_4");
    EXPECT_EQ(code_identifier("  a // b__c_ "), "a_b_c");
    EXPECT_EQ(code_identifier("4 ways"), "ways");
    EXPECT_EQ(code_identifier("<expression>"), "expression");
    EXPECT_EQ(code_identifier("φ"), "automaton");
    EXPECT_EQ(code_identifier(""), "automaton");
    EXPECT_EQ(code_identifier("gl_Position"), "ggl_Position");
    EXPECT_EQ(code_identifier("gl"), "ggl");
    EXPECT_EQ(code_identifier(std::string(500, 'x')).size(), 40U);
}

TEST(AutomatonCode, CommentsCannotBeEndedOrCarriedOn) {
    EXPECT_EQ(block_comment_text("a*/b"), "a* /b");
    EXPECT_EQ(block_comment_text("/*/"), "/ * /");
    EXPECT_EQ(block_comment_text("**//"), "** //");
    EXPECT_EQ(block_comment_text("end\\"), "end?");
    EXPECT_EQ(block_comment_text("two\nlines"), "two?lines");
    EXPECT_THAT(block_comment_text("\xE2\x80\xAE"), Not(HasSubstr("\xE2\x80\xAE")));
}

} // namespace
} // namespace internode
