// SPDX-License-Identifier: MIT

#include "cli/point_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

namespace {

ModuleWord whole(const LoadedPoints& loaded, Derivation derivation) {
    if (derivation.problem) throw derivation_failure(loaded, *derivation.problem);
    return std::move(derivation.word);
}

ModuleWord interpreted(const LoadedPoints& loaded, const ModuleWord& word) {
    return whole(loaded, interpret(loaded.system, word, loaded.derive));
}

std::string line_of(const LoadedPoints& loaded, const ModuleWord& word, std::size_t passes) {
    return to_string(word, loaded.system.grammar(), loaded.system.layout(passes)) + '\n';
}

/// One cycle more, `before` cycles after the start.
ModuleWord next_cycle(const LoadedPoints& loaded, ModuleWord word, std::uint64_t before) {
    const std::uint64_t steps = loaded.system.cycle().size();
    for (std::uint64_t step = before * steps; step < (before + 1) * steps; ++step)
        word = whole(loaded, derive_step(loaded.system, word, step, loaded.derive));
    return word;
}

} // namespace

void refuse_growth(const LoadedPoints& loaded, std::uint64_t cycles) {
    constexpr std::uint64_t told = 1'000'000'000'000'000'000; // larger numbers are not read any more
    const std::uint64_t most = loaded.derive.max_modules;
    const auto length = predicted_length(loaded.system, loaded.word, cycles, std::max(most, told));
    if (length && *length > most)
        throw failure(ExitCode::Refused,
                      fmt::format("after {} cycles the word would have {} modules; {} are allowed", cycles,
                                  *length > told ? fmt::format("more than {}", told) : std::to_string(*length), most),
                      "fewer cycles, or a larger --max-modules");
}

ModuleWord derived_word(const LoadedPoints& loaded, std::uint64_t cycles) {
    return whole(loaded, derive(loaded.system, loaded.word, cycles, loaded.derive));
}

PointStrands drawn(const LoadedPoints& loaded, const ModuleWord& word) {
    return strands(interpreted(loaded, word), loaded.system, loaded.system.grammar().interpretations.size());
}

std::vector<PictureLevel> all_levels(const LoadedPoints& loaded, std::uint64_t cycles) {
    refuse_growth(loaded, cycles);
    const std::uint64_t first_shown = cycles < max_level_panels ? 1 : cycles - (max_level_panels - 2);
    std::vector<PictureLevel> levels{{0, drawn(loaded, loaded.word)}};
    ModuleWord word = loaded.word;
    for (std::uint64_t cycle = 1; cycle <= cycles; ++cycle) {
        word = next_cycle(loaded, std::move(word), cycle - 1);
        if (cycle >= first_shown) levels.push_back({cycle, drawn(loaded, word)});
    }
    return levels;
}

void write_word(Sink& sink, const LoadedPoints& loaded, const ModuleWord& word) {
    sink.write(line_of(loaded, interpreted(loaded, word), loaded.system.grammar().interpretations.size()));
}

void write_trace(Sink& sink, const LoadedPoints& loaded, std::uint64_t cycles) {
    refuse_growth(loaded, cycles);
    ModuleWord word = loaded.word;
    sink.write(line_of(loaded, word, 0));
    for (std::uint64_t step = 0; step < cycles * loaded.system.cycle().size(); ++step) {
        word = whole(loaded, derive_step(loaded.system, word, step, loaded.derive));
        sink.write(line_of(loaded, word, 0));
    }
    for (std::size_t pass = 0; pass < loaded.system.grammar().interpretations.size(); ++pass) {
        word = whole(loaded, interpret_pass(loaded.system, word, pass, loaded.derive));
        sink.write(line_of(loaded, word, pass + 1));
    }
}

DerivationTree all_steps(const LoadedPoints& loaded, std::uint64_t cycles) {
    refuse_growth(loaded, cycles);
    const auto table_of = loaded.system.cycle();
    DerivationTree tree;
    tree.words.push_back(loaded.word);
    tree.row_names.emplace_back(loaded.start == "the axiom" ? "axiom" : "polygon");
    for (std::uint64_t step = 0; step < cycles * table_of.size(); ++step) {
        StepRecord& record = tree.steps.emplace_back();
        tree.words.push_back(whole(loaded, derive_step(loaded.system, tree.words.back(), step, loaded.derive, record)));
        const auto table = table_of[step % table_of.size()];
        tree.row_names.push_back(fmt::format("step {}", step + 1));
        if (table) tree.row_names.back() += fmt::format(" ({})", loaded.system.grammar().tables[*table]);
        if (!fits_in_tree(tree.words))
            throw failure(ExitCode::Refused,
                          fmt::format("a tree shows words of at most {} modules, {} in all: step {} has more",
                                      max_tree_row, max_tree_modules, step + 1),
                          "fewer cycles, or a smaller polygon");
    }
    return tree;
}

} // namespace internode::cli
