// SPDX-License-Identifier: MIT
//
// The installed library from end to end: a grammar is read, decided and used to refine a square.

#include <internode/curve/refinement.h>
#include <internode/grammar/intervals/parse.h>
#include <internode/interval/validity.h>

#include <cstdio>

int main() {
    const internode::ParsedGrammar parsed = internode::parse_grammar("L -> S L, S -> L", "example");
    if (!parsed.grammar) return 1;
    const internode::Verdict verdict = internode::validate(*parsed.grammar);
    if (!verdict.system) return 1;

    const auto l = *verdict.system->alphabet().find("L");
    const auto s = *verdict.system->alphabet().find("S");
    internode::CurveData square;
    square.degree = 2;
    square.ends = internode::Ends::Circular;
    square.word = {l, s, l, s};
    square.dimension = 2;
    square.points = {0, 0, 1, 0, 1, 1, 0, 1};
    const internode::CheckedCurve checked = internode::make_curve(*verdict.system, square);
    if (!checked.curve) return 1;

    const internode::Curve refined = internode::refine(*checked.curve, 3);
    for (std::size_t i = 0; i < refined.size(); ++i)
        std::printf("%g %g\n", refined.points()[2 * i], refined.points()[2 * i + 1]);
    return refined.size() == 16 ? 0 : 1;
}
