// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/parse.h"
#include "tests/grammar/error_cases.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace internode {

namespace {

using tests::ErrorCase;

constexpr std::string_view begin = "begin with `intervals NAME`, then one rule a line: `L -> S L`";
constexpr std::string_view statement = "a statement is a rule `L -> S L`, `axiom L S`, `length L = 3/2` or `ring`";
constexpr std::string_view one_symbol = "a rule of an interval grammar has one symbol before `->`";
constexpr std::string_view nothing = "an interval cannot become nothing: write at least one symbol after `->`";
constexpr std::string_view name = "a name is a letter, then letters, digits, `_` or `'`";

void expect_errors(const std::vector<ErrorCase>& cases) {
    tests::expect_errors(cases, [](std::string_view text) { return parse_grammar(text, "t").errors; });
}

} // namespace

TEST(ParseError, OfTheFirstStatement) {
    const std::string no_quotes =
        fmt::format("{} | any other name stands in quotes: `intervals \"my-grammar\"`\n", name);
    expect_errors({
        {"", fmt::format("1:1 the text has no statement | {}\n", begin)},
        {" \n// nothing\n", fmt::format("1:1 the text has no statement | {}\n", begin)},
        {"intervals x", "1:1 a grammar without rules | write one rule a line: `L -> S L`\n"},
        {"\nintervals x\naxiom 0", "2:1 a grammar without rules | write one rule a line: `L -> S L`\n"},
        {"points chaikin\nP(u) < P(v) -> P(u)",
         fmt::format("1:1 a point grammar where an interval grammar is wanted | {}\n", begin)},
        {"patches x\nA -> [B]",
         fmt::format("1:1 a grammar of kind `patches`: this version reads `intervals` and `points` only | {}\n",
                     begin)},
        {"mesh loop",
         fmt::format("1:1 a grammar of kind `mesh`: this version reads `intervals` and `points` only | {}\n", begin)},
        {"interval x\nL -> L S", "1:1 `interval` is no kind of grammar | did you mean `intervals`?\n"
                                 "2:8 `S` has no rule | write `S -> S` if it should stay whole\n"},
        {"Intervals x\nL -> L", "1:1 `Intervals` is no kind of grammar | did you mean `intervals`?\n"},
        {"point x\nL -> S", "1:1 `point` is no kind of grammar | did you mean `points`?\n"},
        {"1.0,2.0\n3.0,4.0\n", fmt::format("1:1 the first statement must name the kind of grammar | {}\n", begin)},
        {"axiom L\nL -> L L", fmt::format("1:1 the first statement must name the kind of grammar | {}\n", begin)},
        {"intervals my-grammar\nL -> L", "1:11 " + no_quotes},
        {"intervals 3\nL -> L", "1:11 " + no_quotes},
        {"intervals a b\nL -> L", "1:13 the statement goes on after the name of the grammar | a name with blanks or "
                                  "signs stands in quotes; a statement ends with its line\n"},
        {"intervals \"a\nL -> L", "1:11 a quoted name without its second quote\n"},
        {"intervals \"\\q\"\nL -> L",
         "1:11 an escape that is not `\\\"`, `\\\\` or `\\u{...}` of a printable character\n"},
        {"intervals x L -> L L", "1:1 `intervals x L` is not one symbol | the kind of the grammar stands on a line of "
                                 "its own\n"},
        {"L -> L\nintervals x", "2:1 the kind of a grammar is named once, in its first statement\n"},
    });
}

TEST(ParseError, OfSymbolsWithoutRules) {
    expect_errors({
        {"L -> S L", "1:6 `S` has no rule | write `S -> S` if it should stay whole\n"},
        {"L -> s L S\nS -> L", "1:6 `s` has no rule | did you mean `S`? Or write `s -> s` if it should stay whole\n"},
        {"L -> S Q Q\nS -> Q L T", "1:8 `Q` has no rule | write `Q -> Q` if it should stay whole\n"
                                   "2:10 `T` has no rule | write `T -> T` if it should stay whole\n"},
        {"L -> L L0", "1:8 `L0` has no rule | `L0` is one symbol: write `L 0`\n"},
        {"A1 -> A1 A100", "1:10 `A100` has no rule | `A100` is one symbol: write `A1 0 0`\n"},
        {"A11 -> A11 A12", "1:12 `A12` has no rule | did you mean `A11`? Or write `A12 -> A12` if it should stay "
                           "whole\n"},
        {"intervals\naxiom L S\nL -> L", "2:9 `S` has no rule | write `S -> S` if it should stay whole\n"},
        {"L -> L\nlength S = 1", "2:8 `S` has no rule | write `S -> S` if it should stay whole\n"},
        {"length -> L\nL -> L",
         "1:1 `length` is not one symbol | a rule of an interval grammar has one symbol before `->`\n"},
    });
}

TEST(ParseError, OfRules) {
    expect_errors({
        {"L -> L\nL -> L L", "2:1 a second rule for `L` | the first is in line 1\n"},
        {"L ->", fmt::format("1:3 an empty successor | {}\n", nothing)},
        {"L -> , S -> S", fmt::format("1:3 an empty successor | {}\n", nothing)},
        {"L ->\nS -> S", fmt::format("1:3 an empty successor | {}\n", nothing)},
        {"L -> // S\n\n  S -> S", fmt::format("1:3 an empty successor | {}\n", nothing)},
        {"L -> L\nS -> \xCE\xB5",
         "2:6 an interval cannot become nothing | a rule has at least one symbol after `->`\n"},
        {"L -> .", "1:6 `.` has no meaning in a word | a rule has at least one symbol after `->`\n"},
        {"-> L\nL -> L", fmt::format("1:1 no symbol before `->` | {}\n", one_symbol)},
        {"LS -> L", fmt::format("1:1 `LS` is not one symbol | {}\n", one_symbol)},
        {"L < S > L -> L", fmt::format("1:1 `L < S > L` is not one symbol | {}\n", one_symbol)},
        {"L(x) -> L", fmt::format("1:1 `L(x)` is not one symbol | {}\n", one_symbol)},
        {"0 -> L L\nL -> L", "1:1 `0` has no rule of its own: it stays `0` | leave this rule out\n"},
        {"L -> 0 L 0", "1:6 `0` may stand in words only, never in a rule | an interval of length zero comes from the "
                       "axiom and stays as it is\n"},
        {"L -> L -> S", "1:8 a second `->` in one statement | begin each rule on a line of its own, or after `,`\n"},
        {"L -> (L L)", "1:6 parentheses without a power | write `(L S)^2`, or leave the parentheses out\n"},
        {"L -> (L", "1:6 `(` is never closed\n"},
        {"L -> L)", "1:7 `)` was never opened\n"},
        {"L -> (L\nS -> L)", "1:6 `(` is never closed\n2:7 `)` was never opened\n"},
        {"L -> ()^2", "1:6 empty parentheses\n"},
        {"L -> ((L)^2)^2", "1:7 parentheses inside parentheses | write the word with one level; `ring` makes an axiom "
                           "circular without parentheses\n"},
        {"L -> L^", "1:7 `^` without a count | write `L^3` or `(L S)^3`\n"},
        {"L -> L^S", "1:7 `^` without a count | write `L^3` or `(L S)^3`\n"},
        {"L -> ^3", "1:6 `^` has no meaning in a word | write `L^3` or `(L S)^3`\n"},
        {"L -> L^0", "1:8 a power must be at least 1\n"},
        {"L -> L^2^3", "1:9 a power of a power | write one power\n"},
        {"L -> 2 L", "1:6 `2` is no letter of a word | to repeat a letter write `L^2`; `0` is the interval of length "
                     "zero\n"},
        {"L -> L _", "1:8 `_` follows no symbol | a symbol is a letter, then digits, `_` or `'`\n"},
        {"L -> L \xC3\xA9", "1:8 `\xC3\xA9` has no meaning in a word\n"},
        {"L -> L | L", "1:8 `|` has no meaning in a word\n"},
    });
}

TEST(ParseError, OfOtherStatements) {
    expect_errors({
        {"L -> L\nlenght L = 2", "2:1 `lenght` begins no statement | did you mean `length`?\n"},
        {"L -> L\nAxiom L", "2:1 `Axiom` begins no statement | did you mean `axiom`?\n"},
        {"L -> L\naxoim L", "2:1 `axoim` begins no statement | did you mean `axiom`?\n"},
        {"L -> L\nL L", fmt::format("2:1 `L` begins no statement | {}\n", statement)},
        {"L -> L\n* L", fmt::format("2:1 `*` begins no statement | {}\n", statement)},
        {"L -> L S\nS = L", "2:3 a rule is written with `->` | write `L -> S L`\n"},
        {"L -> L S\nS: L", "2:2 a rule is written with `->` | write `L -> S L`\n"},
        {"L -> L\ntable x", fmt::format("2:1 an interval grammar has no `table` | {}\n", statement)},
        {"L -> L\ncycle x", fmt::format("2:1 an interval grammar has no `cycle` | {}\n", statement)},
        {"L -> L\ninput x", fmt::format("2:1 an interval grammar has no `input` | {}\n", statement)},
        {"L -> L\nring", "2:1 `ring` without an axiom | write `axiom (L S)`, or leave `ring` out\n"},
        {"L -> L\naxiom L\nring\nring", "4:1 a second `ring` | the first is in line 3\n"},
        {"L -> L\naxiom L\nring L", "3:6 `ring` stands alone | write it on a line of its own\n"},
        {"L -> L\n)", "2:1 `)` was never opened\n"},
        {"L -> L\n(", "2:1 `(` is never closed\n"},
    });
}

TEST(ParseError, OfAxioms) {
    expect_errors({
        {"L -> L\naxiom", "2:1 `axiom` without a word | write `axiom L S L`, or `axiom (L S)` for a circle\n"},
        {"L -> L\naxiom = L", "2:7 a sign between `axiom` and its word | write `axiom L S L`\n"},
        {"L -> L\naxiom L\naxiom L", "3:1 a second axiom | the first is in line 2\n"},
        {"L -> L\naxiom (L", "2:7 `(` is never closed\n"},
        {"L -> L\naxiom (L) L",
         "2:7 parentheses without a power | `(L S)^2` repeats; parentheses round the whole word make it circular\n"},
        {"L -> L\naxiom (L,L)", "2:9 `,` has no meaning in a word | letters stand side by side or between blanks\n"},
        {"L -> L\naxiom ((L)^2)", "2:8 parentheses inside parentheses | write the word with one level; `ring` makes an "
                                  "axiom circular without parentheses\n"},
        {"L -> L\naxiom ()", "2:7 empty parentheses\n"},
        {"L -> L\naxiom 0 1", "2:9 `1` is no letter of a word | to repeat a letter write `L^1`; `0` is the interval of "
                              "length zero\n"},
    });
}

TEST(ParseError, OfLengths) {
    const std::string number = " is not a number | write `3/2` or `1.5`; at most 1000 digits, exponent at most 400\n";
    const std::string positive = " | `0` in a word is the interval of length zero\n";
    expect_errors({
        {"L -> L\nlength", "2:1 `length` needs one symbol | write `length L = 3/2`\n"},
        {"L -> L\nlength = 2", "2:8 `length` needs one symbol | write `length L = 3/2`\n"},
        {"L -> L\nlength LL = 2", "2:8 `length` needs one symbol | write `length L = 3/2`\n"},
        {"L -> L\nlength 0 = 2", "2:8 `length` needs one symbol | write `length L = 3/2`\n"},
        {"L -> L\nlength L", "2:8 no `=` after `length L` | write `length L = 3/2`\n"},
        {"L -> L\nlength L 2", "2:10 no `=` after `length L` | write `length L = 3/2`\n"},
        {"L -> L\nlength L =", "2:10 no number after `=` | write `length L = 3/2`\n"},
        {"L -> L\nlength L = x", "2:12 `x`" + number},
        {"L -> L\nlength L = 1/0", "2:12 `1/0`" + number},
        {"L -> L\nlength L = 1 2", "2:12 `1 2`" + number},
        {"L -> L\nlength L = nan", "2:12 `nan`" + number},
        {"L -> L\nlength L = 1e401", "2:12 `1e401`" + number},
        {"L -> L\nlength L = 0", "2:12 a length must be positive, not `0`" + positive},
        {"L -> L\nlength L = -3/2", "2:12 a length must be positive, not `-3/2`" + positive},
        {"L -> L\nlength L = 3/2\nlength L = 1.5\nlength L = 2",
         "4:8 the length of `L` is 2 here and 3/2 before | two declarations must agree exactly\n"},
    });
}

TEST(ParseError, OfBytesThatAreNoText) {
    const std::string nul = std::string("L -> L") + '\0' + "\nS -> S";
    expect_errors({
        {"L -> L \xFF", "1:8 the byte \\xFF is not UTF-8 | save the text as UTF-8\n"},
        {"L -> L // \xC3(", "1:11 the byte \\xC3 is not UTF-8 | save the text as UTF-8\n"},
        {"\xED\xA0\x80 L -> L", "1:1 the byte \\xED is not UTF-8 | save the text as UTF-8\n"},
        {nul, "1:7 the control character \\x00 | a grammar is plain text\n"},
        {"L -> L\x1B[31m", "1:7 the control character \\x1B | a grammar is plain text\n"},
        {"intervals \"a\x7F\"\nL -> L", "1:13 the control character \\x7F | a grammar is plain text\n"},
        {"\xFF", "1:1 the byte \\xFF is not UTF-8 | save the text as UTF-8\n"},
    });
}

TEST(ParseError, AllOfATextComeInTheOrderOfTheirPlaces) {
    EXPECT_EQ(
        tests::error_lines(parse_grammar("intervals x\nL -> S (\nL -> L\naxiom 3\nlength L = 0\nfoo\n", "t").errors),
        "2:6 `S` has no rule | write `S -> S` if it should stay whole\n"
        "2:8 `(` is never closed\n"
        "3:1 a second rule for `L` | the first is in line 2\n"
        "4:7 `3` is no letter of a word | to repeat a letter write `L^3`; `0` is the interval of length zero\n"
        "5:12 a length must be positive, not `0` | `0` in a word is the interval of length zero\n" +
            fmt::format("6:1 `foo` begins no statement | {}\n", statement));
}

TEST(ParseError, ColumnsCountCodePoints) {
    const ParsedGrammar parsed = parse_grammar("intervals \"\xC3\xA9\xE4\xB8\xAD\" x\nL -> L", "t");
    ASSERT_EQ(parsed.errors.size(), 1u);
    EXPECT_EQ(parsed.errors.front().column, 16u);
    EXPECT_EQ(parsed.errors.front().source, "t");
    EXPECT_EQ(parsed.errors.front().source_line, "intervals \"\xC3\xA9\xE4\xB8\xAD\" x");
}

} // namespace internode
