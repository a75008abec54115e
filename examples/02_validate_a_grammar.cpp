// SPDX-License-Identifier: MIT
//
// Reads a grammar, decides whether it subdivides intervals, and says how: its ratio and lengths. What is wrong with a
// text or a grammar is a value, with places and reasons.

#include <internode/internode.h>

#include <cstdio>
#include <string_view>

void decide(std::string_view text) {
    const internode::ParsedGrammar parsed = internode::parse_grammar(text, "example");
    if (!parsed.grammar) {
        std::printf("%s", internode::to_string(parsed.errors).c_str());
        return;
    }

    const internode::Verdict verdict = internode::validate(*parsed.grammar);
    for (const internode::Reason& reason : verdict.reasons) std::printf("%s\n", reason.message.c_str());
    if (!verdict.system) return;

    const internode::IntervalSystem& system = *verdict.system;
    const auto exactly = [&](const internode::Number& number) {
        return number.to_string(system.field(), system.ratio_name());
    };
    std::printf("ratio %s = %.6f\n", exactly(system.ratio()).c_str(), system.ratio().to_double());
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        std::printf("length of %s: %s = %.6f\n", system.alphabet().names()[i].c_str(),
                    exactly(system.lengths()[i]).c_str(), system.lengths()[i].to_double());
}

int main() {
    decide("L -> S L, S -> L");
    decide("A -> A A, B -> B");
    decide("L -> S L, S -> M");
}
