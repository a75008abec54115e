// SPDX-License-Identifier: MIT
//
// What does not depend on the points is derived once, as an automaton and a plan, and applied to many polygons.

#include <internode/internode.h>

#include <cstdio>
#include <vector>

int main() {
    const internode::IntervalSystem system =
        internode::validate(*internode::parse_grammar("L -> S L, S -> L", "example").grammar).system.value();
    const internode::Word word = internode::parse_word("LSLLS", system.alphabet(), "example").axiom.word;

    const internode::RefinementPlan plan(system, 3, word, internode::Ends::Circular, 6);
    std::printf("%zu points become %zu, by an automaton of %zu states\n", plan.input_size(), plan.output_size(),
                plan.automaton().state_count());

    constexpr std::size_t polygons = 1000;
    std::vector<double> points;
    for (std::size_t i = 0; i < polygons; ++i)
        for (const double number : {0., 0., 4., 0., 4., 3., 2., 5., 0., 3.}) points.push_back(number + double(i));
    std::vector<double> fine(polygons * plan.output_size() * 2);
    plan.apply_each<double>(points, polygons, 2, fine, {.threads = 2});

    std::printf("first point of the first polygon %.6f %.6f, of the last %.6f %.6f\n", fine[0], fine[1],
                fine[fine.size() - 2 * plan.output_size()], fine[fine.size() - 2 * plan.output_size() + 1]);
}
