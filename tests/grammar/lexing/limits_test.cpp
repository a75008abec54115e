// SPDX-License-Identifier: MIT
//
// What is too large is refused with its number, and hostile sizes are met in linear time and bounded memory. Each of
// these texts would hang, overflow the stack or exhaust memory if it were not.

#include "internode/grammar/lexing/limits.h"

#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/intervals/print.h"
#include "internode/grammar/lexing/normal_form.h"
#include "tests/fixtures/small_stack.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <algorithm>

namespace internode {

namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;
using tests::repeated;

std::string first_error(std::string_view text) {
    const ParsedGrammar parsed = parse_grammar(text, "t");
    return parsed.errors.empty() ? "" : parsed.errors.front().message;
}

std::vector<std::string> refusals_of_normal_form(std::string_view printed) {
    Complaints complaints("L -> L", "t");
    check_normal_form(printed, complaints);
    std::vector<std::string> messages;
    for (const Diagnostic& error : std::move(complaints).diagnostics()) messages.push_back(error.message);
    return messages;
}

} // namespace

TEST(Limits, OfTheBytesOfAText) {
    EXPECT_EQ(first_error(std::string(max_grammar_bytes + 1, ' ')), "a text of 16777217 bytes, more than 16777216");
    EXPECT_EQ(first_error(std::string(max_grammar_bytes, '\n')), "the text has no statement");
}

TEST(Limits, OfTheBytesOfALine) {
    EXPECT_EQ(first_error("L -> L //" + std::string(max_line_bytes, 'x')),
              "a line of 12582921 bytes, more than 12582912");
    EXPECT_EQ(first_error("L -> L //" + std::string(max_line_bytes - 9, 'x')), "");
}

TEST(Limits, OfSymbols) {
    std::string text;
    for (std::size_t i = 0; i < max_symbols; ++i) text += fmt::format("A{0}->A{0}\n", i);
    EXPECT_EQ(first_error(text), "");
    EXPECT_EQ(first_error(text + "B->B"), "more than 100000 symbols");
}

TEST(Limits, OfTheLettersOfARule) {
    EXPECT_EQ(first_error("L -> L^1000000"), "");
    EXPECT_EQ(first_error("L -> L^1000001"), "this power makes a word of more than 1000000 letters");
    EXPECT_EQ(first_error("L -> L^1000000 L"), "a word of more than 1000000 letters");
    EXPECT_EQ(first_error("L -> (L^1000000)^1000000"), "this power makes a word of more than 1000000 letters");
    EXPECT_EQ(first_error("L -> L^" + std::string(100'000, '9')),
              "this power makes a word of more than 1000000 letters");
}

TEST(Limits, OfThePowersOfUnknownSymbols) {
    // A symbol without a rule makes no letters, but would have made some.
    const auto refuses_power = [](std::string_view text) {
        const ParsedGrammar parsed = parse_grammar(text, "t");
        return std::ranges::any_of(parsed.errors, [](const Diagnostic& error) {
            return error.message == "this power makes a word of more than 1000000 letters";
        });
    };
    EXPECT_FALSE(refuses_power("L -> X^1000000"));
    EXPECT_TRUE(refuses_power("L -> X^1000001"));
    EXPECT_TRUE(refuses_power("L -> L X^1000001 L"));
    EXPECT_TRUE(refuses_power("L -> (X Y)^1000001 L"));
    EXPECT_TRUE(refuses_power("L -> L X^" + std::string(100, '9')));
}

TEST(Limits, OfTheLettersOfAllWords) {
    EXPECT_EQ(first_error("L -> L\naxiom L^9999999"), "");
    EXPECT_EQ(first_error("L -> L\naxiom L^10000000"), "this power makes words of more than 10000000 letters in all");
    std::string rules;
    for (int i = 0; i < 11; ++i) rules += fmt::format("A{0} -> A{0}^1000000\n", i);
    EXPECT_EQ(first_error(rules), "words of more than 10000000 letters in all");
}

TEST(Limits, OfWhatIsWrittenOut) {
    const std::string name = fmt::format("A{:1>99}", "");
    EXPECT_THAT(first_error(fmt::format("{0} -> {0}\naxiom {0}^200000", name)),
                StartsWith("written out, this makes a line of 20200"));
    std::string rules;
    for (int i = 0; i < 4; ++i) rules += fmt::format("B{0:1>99} -> B{0:1>99}^50000\n", i);
    EXPECT_THAT(first_error(rules), StartsWith("written out, this makes a text of 20"));
}

TEST(Limits, OfEveryLineThatIsWrittenOutToTheByte) {
    const std::string most(max_line_bytes, 'L');
    for (const std::string_view before : {"", "L\n"})
        for (const std::string_view after : {"", "\nLL\n"}) {
            EXPECT_THAT(refusals_of_normal_form(fmt::format("{}{}{}", before, most, after)), IsEmpty());
            EXPECT_THAT(refusals_of_normal_form(fmt::format("{}{}L{}", before, most, after)),
                        ElementsAre("written out, this makes a line of 12582913 bytes, more than 12582912"));
        }
}

TEST(Limits, OfTheTextThatIsWrittenOutToTheByte) {
    std::string text = repeated("1234567\n", max_grammar_bytes / 8);
    EXPECT_THAT(refusals_of_normal_form(text), IsEmpty());
    text += '1';
    EXPECT_THAT(refusals_of_normal_form(text),
                ElementsAre("written out, this makes a text of 16777217 bytes, more than 16777216"));
    EXPECT_THAT(refusals_of_normal_form(std::string(max_grammar_bytes + 1, '1')), SizeIs(2)) << "line and text";
}

TEST(Limits, OfNames) {
    const std::string name = fmt::format("A{:1>99}", "");
    EXPECT_EQ(first_error(name + " -> " + name), "");
    EXPECT_EQ(first_error(name + "1 -> L\nL -> L"), "a symbol of 101 characters, more than 100");
    EXPECT_EQ(first_error("L -> L " + name + "1"), "a symbol of 101 characters, more than 100");
    EXPECT_EQ(first_error("intervals " + name + "\nL -> L"), "");
    EXPECT_EQ(first_error("intervals " + name + "1\nL -> L"), "a name of 101 bytes, more than 100");
}

TEST(Limits, OfDigits) {
    const std::string digits(max_digits, '7');
    EXPECT_EQ(first_error("L -> L\nlength L = " + digits), "");
    EXPECT_THAT(first_error("L -> L\nlength L = 7" + digits), EndsWith("is not a number"));
    EXPECT_THAT(first_error("L -> L\nlength L = " + digits + "e5"), EndsWith("is not a number"));
    EXPECT_EQ(first_error("L -> L\nlength L = 1e400"), "");
    EXPECT_THAT(first_error("L -> L\nlength L = 1e401"), EndsWith("is not a number"));
}

TEST(Limits, OfErrorsKept) {
    const ParsedGrammar parsed = parse_grammar("L -> L\n" + repeated("?\n", 100'000), "t");
    ASSERT_EQ(parsed.errors.size(), max_kept_errors + 1);
    EXPECT_EQ(parsed.errors[999].line, 1001u);
    EXPECT_EQ(parsed.errors.back().message, "more than 1000 errors; the rest of the text is not judged");
    EXPECT_THAT(to_string(parsed.errors), EndsWith("and 981 more errors\n"));
}

TEST(Limits, ADeepWordIsRefusedWithoutDepth) {
    tests::run_on_stack(std::size_t{8} << 20, [] {
        const std::string deep(1'000'000, '(');
        EXPECT_EQ(first_error("L -> " + deep), "`(` is never closed");
        EXPECT_EQ(first_error("L -> " + deep + "L" + std::string(1'000'000, ')')), "parentheses inside parentheses");
        EXPECT_EQ(first_error("L -> " + std::string(1'000'000, ')')), "`)` was never opened");
        EXPECT_EQ(first_error(deep), "the first statement must name the kind of grammar");
    });
}

TEST(Limits, LongLinesOfErrorsTakeLinearTimeAndSpace) {
    for (const std::string_view piece :
         {"-> ", "Q,", "\",", "\"\\", "=", "length L = 1e400,", "L^9", "x^1000000 ", "0^1000000 ", "\xFF ", "^", "L->",
          ",", "'", "L-> L L,", "// ", "\xCE\xB5", "axiom "}) {
        const ParsedGrammar parsed =
            parse_grammar("L -> L," + repeated(piece, (std::size_t{1} << 18) / piece.size()), "t");
        EXPECT_LE(parsed.errors.size(), max_kept_errors + 1);
        for (const Diagnostic& error : parsed.errors) EXPECT_LE(error.source_line.size(), 1000u);
        static_cast<void>(to_string(parsed.errors));
    }
}

TEST(Limits, ManyUnknownSymbolsTakeLinearTime) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += fmt::format("A{} -> B{}\n", i, i);
    const ParsedGrammar parsed = parse_grammar(text, "t");
    EXPECT_EQ(parsed.errors.size(), max_kept_errors + 1);
    EXPECT_EQ(parsed.errors.front().message, "`B0` has no rule");
}

TEST(Limits, TheTableNamesEachLimit) {
    for (const Limit& limit : grammar_limits) {
        EXPECT_GT(limit.value, 0u);
        EXPECT_FALSE(limit.name.empty() || limit.unit.empty());
    }
}

} // namespace internode
