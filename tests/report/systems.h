// SPDX-License-Identifier: MIT
//
// Systems and curves that the tests of this room share.

#pragma once

#include "internode/curve/curve.h"
#include "internode/report/generator.h"
#include "tests/fixtures/interval_systems.h"

#include <gtest/gtest.h>

#include <string>

namespace internode::testing_report {

/// A name that is markup in every language of this room, and invisible where it can be.
inline const std::string hostile = "</script><img src=x onerror=\"a'b\">]]>*/\\N&amp;\x1b[2J\xE2\x80\xAE\xFF";

using tests::grammar_of;
using tests::system_of;

inline const std::string fibonacci = "intervals fibonacci\nL -> S L\nS -> L\n";
inline const std::string slow_growth = "intervals slow\nA1 -> A3 A3\nA2 -> A1\nA3 -> A2\n";

/// Fibonacci with symbols and a name that nobody would choose in good faith.
inline IntervalGrammar hostile_grammar() {
    IntervalGrammar grammar;
    grammar.name = hostile;
    const Symbol first = grammar.alphabet.add(hostile);
    const Symbol second = grammar.alphabet.add(hostile + hostile);
    grammar.rules = Morphism({{second, first}, {first}});
    return grammar;
}

/// A polygon of seven points in the plane, its word L S L L S L L … as long as it must be.
inline Curve curve_of(const IntervalSystem& system, int degree, Ends ends, std::size_t dimension = 2) {
    const std::vector<double> coordinates{0, 0, 4, 0.5, 5, 3, 3, 2, 1.5, 4, -1, 2.25, -0.5, 1, 2, 2};
    CurveData data;
    data.degree = degree;
    data.ends = ends;
    data.dimension = dimension;
    data.points.assign(coordinates.begin(), coordinates.begin() + (dimension == 1 ? 8 : 14));
    const Word pattern{to_symbol(0), to_symbol(1), to_symbol(0)};
    const std::size_t points = data.points.size() / dimension;
    data.word = repeated(pattern, points + (ends == Ends::Open ? static_cast<std::size_t>(degree) : 0));
    const CheckedCurve checked = make_curve(system, data);
    for (const std::string& problem : checked.problems) ADD_FAILURE() << problem;
    return checked.curve.value();
}

inline const Generator drawer{"0.1.0", "internode subdivide"};

/// Nothing of the hostile name is markup, and no byte of it commands a terminal or a reader's eye.
inline void expect_inert(const std::string& text) {
    for (const char* const bad : {"<img", "</script", "<script", "]]>", "onerror=\"", "\x1b", "\xE2\x80\xAE", "\xFF"})
        EXPECT_EQ(text.find(bad), std::string::npos) << bad;
}

} // namespace internode::testing_report
