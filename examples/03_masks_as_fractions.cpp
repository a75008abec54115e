// SPDX-License-Identifier: MIT
//
// The weights with which a control point goes into the next step, exactly: Chaikin's 1/4 3/4 3/4 1/4 and what becomes
// of it where intervals of two lengths meet.

#include <internode/internode.h>

#include <cstdio>
#include <string>

void print_mask(const internode::IntervalSystem& system, const std::string& word) {
    const internode::ParsedWord parsed = internode::parse_word(word, system.alphabet(), "example");
    const internode::Mask mask = internode::mask(system, parsed.axiom.word);
    std::printf("%s:", word.c_str());
    for (const internode::MaskEntry& entry : mask.entries)
        std::printf("  %s", entry.weight.to_string(system.field(), system.ratio_name()).c_str());
    std::printf("\n");
}

int main() {
    const auto system = [](const char* text) {
        return internode::validate(*internode::parse_grammar(text, "example").grammar).system.value();
    };
    print_mask(system("A -> A A"), "AAA");

    const internode::IntervalSystem fibonacci = system("L -> S L, S -> L");
    for (const char* word : {"LSL", "SLL", "LLS"}) print_mask(fibonacci, word);
}
