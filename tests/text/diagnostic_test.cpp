// SPDX-License-Identifier: MIT

#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"
#include "internode/text/printable.h"

#include <gtest/gtest.h>

namespace internode {

namespace {

Diagnostic at(std::size_t column, std::string line, std::size_t width = 1) {
    Diagnostic result;
    result.source = "a.lsys";
    result.line = 3;
    result.column = column;
    result.width = width;
    result.message = "wrong";
    result.source_line = std::move(line);
    return result;
}

} // namespace

TEST(Diagnostic, ShowsPlaceLineCaretAndHint) {
    Diagnostic error = at(6, "L -> Sxx L", 3);
    error.hint = "do better";
    EXPECT_EQ(to_string(error), "a.lsys:3:6: error: wrong\n    L -> Sxx L\n         ^^^\nhint: do better\n");
}

TEST(Diagnostic, LeavesOutWhatIsNotKnown) {
    Diagnostic error = at(0, "");
    EXPECT_EQ(to_string(error), "a.lsys:3: error: wrong\n");
    error.line = 0;
    EXPECT_EQ(to_string(error), "a.lsys: error: wrong\n");
    EXPECT_EQ(to_string(at(0, "the line")), "a.lsys:3: error: wrong\n    the line\n");
}

TEST(Diagnostic, PutsTheCaretPastTheEndOfALine) {
    EXPECT_EQ(to_string(at(5, "L ->")), "a.lsys:3:5: error: wrong\n    L ->\n        ^\n");
}

TEST(Diagnostic, AlignsTheCaretBelowTabsWideAndCombiningCharacters) {
    EXPECT_EQ(to_string(at(3, "\tx!")), "a.lsys:3:3: error: wrong\n        x!\n         ^\n");
    EXPECT_EQ(to_string(at(2, "\xE4\xB8\xAD!")), "a.lsys:3:2: error: wrong\n    \xE4\xB8\xAD!\n      ^\n");
    EXPECT_EQ(to_string(at(3, "e\xCC\x81!")), "a.lsys:3:3: error: wrong\n    e\xCC\x81!\n     ^\n");
    EXPECT_EQ(to_string(at(1, "\xE4\xB8\xAD!")), "a.lsys:3:1: error: wrong\n    \xE4\xB8\xAD!\n    ^^\n");
}

TEST(Diagnostic, EscapesWhatCommandsATerminal) {
    EXPECT_EQ(printable("a\x1B[31m"), "a\\u{1b}[31m");
    EXPECT_EQ(printable("\xE2\x80\xAE\xE2\x81\xA6\xE2\x80\x8F"), "\\u{202e}\\u{2066}\\u{200f}");
    EXPECT_EQ(printable("\xC2\x9B\x7F\n"), "\\u{9b}\\u{7f}\\u{a}");
    EXPECT_EQ(printable("\xFF\xC3"), "\\xFF\\xC3");
    EXPECT_EQ(printable("caf\xC3\xA9 \xE2\x82\xAC"), "caf\xC3\xA9 \xE2\x82\xAC");
    EXPECT_EQ(to_string(at(3, "\xFF\x1Bx")), "a.lsys:3:3: error: wrong\n    \\xFF\\u{1b}x\n              ^\n");
    Diagnostic error = at(1, "");
    error.source = "a\nb";
    error.message = "\x07";
    error.hint = "\x1B";
    EXPECT_EQ(to_string(error), "a\\u{a}b:3:1: error: \\u{7}\nhint: \\u{1b}\n");
}

TEST(Diagnostic, CutsALongLineRoundTheCaret) {
    const std::string line = std::string(500, 'a') + "!" + std::string(500, 'b');
    EXPECT_EQ(to_string(at(501, line)), "a.lsys:3:501: error: wrong\n    ..." + std::string(60, 'a') + "!" +
                                            std::string(39, 'b') + "...\n" + std::string(67, ' ') + "^\n");
    EXPECT_EQ(to_string(at(1, line)), "a.lsys:3:1: error: wrong\n    " + std::string(100, 'a') + "...\n    ^\n");
}

TEST(Diagnostic, CutsNothingBeforeACaretInColumn61) {
    EXPECT_EQ(to_string(at(61, std::string(60, 'a') + "!")),
              "a.lsys:3:61: error: wrong\n    " + std::string(60, 'a') + "!\n" + std::string(64, ' ') + "^\n");
    EXPECT_EQ(to_string(at(62, std::string(61, 'a') + "!")),
              "a.lsys:3:62: error: wrong\n    ..." + std::string(60, 'a') + "!\n" + std::string(67, ' ') + "^\n");
}

TEST(Diagnostic, CutsALongLineByItsColumnsNotItsCharacters) {
    // Of a letter and 40 characters of two columns each, 30 fit into the 60 columns before the caret.
    std::string wide;
    for (int i = 0; i < 30; ++i) wide += "\xE4\xBA\x8C";
    std::string line = "a" + wide;
    for (int i = 0; i < 10; ++i) line += "\xE4\xBA\x8C";
    EXPECT_EQ(to_string(at(42, line + "!")),
              "a.lsys:3:42: error: wrong\n    ..." + wide + "!\n" + std::string(67, ' ') + "^\n");
}

TEST(Diagnostic, KnowsAPartOfALine) {
    Diagnostic error = at(1003, "xx!yy");
    error.source_column = 1001;
    EXPECT_EQ(to_string(error), "a.lsys:3:1003: error: wrong\n    ...xx!yy\n         ^\n");
}

TEST(Diagnostic, ShowsTwentyAndCountsTheRest) {
    std::vector<Diagnostic> errors(20, at(0, ""));
    const std::string twenty = to_string(errors);
    EXPECT_EQ(twenty.size(), 20 * to_string(errors.front()).size());
    errors.push_back(at(0, ""));
    EXPECT_EQ(to_string(errors), twenty + "and 1 more error\n");
    errors.resize(1020);
    EXPECT_EQ(to_string(errors), twenty + "and 1000 more errors\n");
    EXPECT_EQ(to_string(std::vector<Diagnostic>{}), "");
}

TEST(DidYouMean, FindsTheNearestName) {
    const std::vector<std::string> names{"axiom", "length", "ring"};
    EXPECT_EQ(did_you_mean("lenght", names), "length");
    EXPECT_EQ(did_you_mean("axoim", names), "axiom");
    EXPECT_EQ(did_you_mean("AXIOM", names), "axiom");
    EXPECT_EQ(did_you_mean("rings", names), "ring");
    EXPECT_EQ(did_you_mean("rnig", names), "ring");
    EXPECT_EQ(did_you_mean("table", names), "");
    EXPECT_EQ(did_you_mean("rixx", names), "") << "two replaced letters are no swap";
    EXPECT_EQ(did_you_mean("", names), "");
    EXPECT_EQ(did_you_mean("x", {"y"}), "");
    EXPECT_EQ(did_you_mean("x", {"X", "y"}), "X");
    EXPECT_EQ(did_you_mean("abc", {}), "");
    EXPECT_EQ(did_you_mean("bisecton", {"trisection", "bisection"}), "bisection");
}

} // namespace internode
