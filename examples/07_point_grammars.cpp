// SPDX-License-Identifier: MIT
//
// A point grammar says itself where the new points go: Chaikin's corner cutting on a ring.

#include <internode/internode.h>

#include <cstdio>
#include <vector>

constexpr const char* chaikin = R"(points chaikin
ring
P(u) < P(v) > P(w) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 w)
)";

int main() {
    const internode::ParsedPointGrammar parsed = internode::parse_point_grammar(chaikin, "example");
    if (!parsed.grammar) {
        std::printf("%s", internode::to_string(parsed.errors).c_str());
        return 1;
    }
    const internode::CheckedPointSystem checked = internode::make_point_system(*parsed.grammar);
    for (const internode::PointProblem& problem : checked.problems) std::printf("%s\n", problem.message.c_str());
    if (!checked.system) return 1;

    const std::vector<double> square{0, 0, 4, 0, 4, 4, 0, 4};
    const internode::ModuleWord word = internode::input_word(*checked.system, square);
    const internode::Derivation derived = internode::derive(*checked.system, word, 2);
    if (derived.problem) return 1;

    const internode::PointStrands drawn = internode::strands(derived.word, *checked.system, 0);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        std::printf("%.4f %.4f\n", drawn.points[2 * i], drawn.points[2 * i + 1]);
}
