// SPDX-License-Identifier: MIT

#include "internode/grammar/points/print_points.h"

#include "internode/grammar/points/parse_points.h"

#include <gtest/gtest.h>

namespace internode {

namespace {

std::string normal_form(std::string_view text) {
    const ParsedPointGrammar parsed = parse_point_grammar(text, "t");
    EXPECT_TRUE(parsed.grammar) << to_string(parsed.errors);
    if (!parsed.grammar) return {};
    std::string printed = print(*parsed.grammar);
    EXPECT_EQ(parse_point_grammar(printed, "p").grammar, parsed.grammar) << printed;
    return printed;
}

} // namespace

TEST(PrintPoints, WritesEachStatementOnce) {
    EXPECT_EQ(normal_form(R"(points chaikin; ring
    axiom P((0,0), 2) E P((1, 0.5),t) [E]
    t = 1/2, n = 2; f(s, t) = min(s, 1) + min(t, 1)
    input P(v, 2) E | P(v, 0) E | P(v, 2)
    always: E < P(v,s) > E : s != 0 and not (s < 1 or s > 3) → I P(v,s) I
    table p
    p1: P(vl,sl) < E > P(vr,sr) ->
        P((1-t) vl + t vr, f(sl, sr)) E^2
    E : (t > 2) -> .
    I : (t) > 2 -> ε : 1/2
    table q
    cycle p q^n r^(2n+1) q^3
    P(v, s) E -> P(-1/16 · v + 9/16 v - 1/16v, -s/2 * t/4)
    table r
    interpretation
    P(v, s) -> Q((v.x/v.z, v.y/v.z)) ?X(s))"),
              R"(points chaikin
ring
t = 1/2
n = 2
f(s, t) = min(s, 1) + min(t, 1)
input P(v, 2) E | P(v, 0) E | P(v, 2)
axiom P((0, 0), 2) E P((1, 1/2), t) [ E ]
cycle p q^n r^(2 n + 1) q^3
always : E < P(v, s) > E : s != 0 and not (s < 1 or s > 3) -> I P(v, s) I
table p
p1 : P(vl, sl) < E > P(vr, sr) -> P((1 - t) vl + t vr, f(sl, sr)) E E
E : (t > 2) -> .
I : (t > 2) -> . : 1/2
table q
P(v, s) E -> P(-1/16 v + 9/16 v - 1/16 v, -s/2 * t/4)
table r
interpretation
P(v, s) -> Q((v.x/v.z, v.y/v.z)) ?X(s)
)");
}

} // namespace internode
