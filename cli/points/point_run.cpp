// SPDX-License-Identifier: MIT

#include "cli/points/point_run.h"

#include "internode/point/growth.h"
#include "internode/point/strands.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

namespace {

ModuleWord whole(const LoadedPoints& loaded, Derivation derivation) {
    if (derivation.problem) throw derivation_failure(loaded, *derivation.problem);
    return std::move(derivation.word);
}

ModuleWord interpreted(const LoadedPoints& loaded, const ModuleWord& word) {
    return whole(loaded, interpret(*loaded.system, word, loaded.derive));
}

std::string line_of(const LoadedPoints& loaded, const ModuleWord& word, std::size_t passes) {
    return to_string(word, loaded.system->grammar(), loaded.system->layout(passes)) + '\n';
}

/// A derivation step by step; the work of all steps together stays within its bound.
class Steps {
public:
    explicit Steps(const LoadedPoints& loaded)
        : loaded_(loaded)
        , left_(loaded.derive)
        , word_(loaded.word) {}

    [[nodiscard]] const ModuleWord& word() const { return word_; }
    [[nodiscard]] std::uint64_t taken() const { return taken_; }

    void step() { take(derive_step(*loaded_.system, word_, taken_, left_)); }
    void step(StepRecord& record) { take(derive_step(*loaded_.system, word_, taken_, left_, record)); }

private:
    void take(Derivation next) {
        left_.max_work -= std::min(left_.max_work, next.work);
        word_ = whole(loaded_, std::move(next));
        ++taken_;
    }

    const LoadedPoints& loaded_;
    DeriveOptions left_;
    ModuleWord word_;
    std::uint64_t taken_ = 0;
};

/// The start and every cycle; of more than max_level_panels the first and the last ones.
std::vector<std::uint64_t> shown_cycles(std::uint64_t cycles) {
    std::vector<std::uint64_t> shown{0};
    const std::uint64_t first = cycles < max_level_panels ? 1 : cycles - (max_level_panels - 2);
    for (std::uint64_t cycle = first; cycle <= cycles; ++cycle) shown.push_back(cycle);
    return shown;
}

} // namespace

void refuse_growth(std::span<const LoadedPoints> parts, std::uint64_t cycles) {
    constexpr std::uint64_t told = 1'000'000'000'000'000'000; // larger numbers are not read any more
    const std::uint64_t most = parts.front().derive.max_modules;
    const std::optional<std::uint64_t> length = predicted_modules(parts, cycles, std::max(most, told));
    if (length && *length > most)
        throw failure(ExitCode::Refused,
                      fmt::format("after {} cycles the {} would have {} modules; {} are allowed", cycles,
                                  parts.size() > 1 ? fmt::format("words of {} parts", parts.size()) : "word",
                                  *length > told ? fmt::format("more than {}", told) : std::to_string(*length), most),
                      "fewer cycles, or a larger --max-modules");
}

std::optional<std::uint64_t> predicted_modules(std::span<const LoadedPoints> parts, std::uint64_t cycles,
                                               std::uint64_t most) {
    std::uint64_t sum = 0;
    for (const LoadedPoints& loaded : parts) {
        const auto length = predicted_length(*loaded.system, loaded.word, cycles, most);
        if (!length) return std::nullopt;
        sum = std::min(sum + std::min(*length, most + 1), most + 1);
    }
    return sum;
}

void take_modules(std::span<LoadedPoints> parts, std::size_t part, std::uint64_t modules) {
    if (part + 1 == parts.size()) return;
    const std::uint64_t left = parts[part].derive.max_modules;
    parts[part + 1].derive.max_modules = left - std::min(left, modules);
}

PointStrands drawn(const LoadedPoints& loaded, const ModuleWord& word) {
    return strands(interpreted(loaded, word), *loaded.system, loaded.system->grammar().interpretations.size());
}

std::vector<PictureLevel> all_levels(std::span<LoadedPoints> parts, std::uint64_t cycles) {
    refuse_growth(parts, cycles);
    std::vector<PictureLevel> levels;
    for (const std::uint64_t cycle : shown_cycles(cycles)) levels.push_back({cycle, {}});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Steps steps(parts[i]);
        for (PictureLevel& level : levels) {
            while (steps.taken() < level.number * parts[i].system->cycle().size()) steps.step();
            level.parts.push_back(drawn(parts[i], steps.word()));
        }
        take_modules(parts, i, steps.word().size());
    }
    return levels;
}

std::string word_text(const LoadedPoints& loaded, const ModuleWord& word) {
    return line_of(loaded, interpreted(loaded, word), loaded.system->grammar().interpretations.size());
}

std::uint64_t write_trace(Sink& sink, const LoadedPoints& loaded, std::uint64_t cycles) {
    Steps steps(loaded);
    sink.write(line_of(loaded, steps.word(), 0));
    while (steps.taken() < cycles * loaded.system->cycle().size()) {
        steps.step();
        sink.write(line_of(loaded, steps.word(), 0));
    }
    ModuleWord word = steps.word();
    for (std::size_t pass = 0; pass < loaded.system->grammar().interpretations.size(); ++pass) {
        word = whole(loaded, interpret_pass(*loaded.system, word, pass, loaded.derive));
        sink.write(line_of(loaded, word, pass + 1));
    }
    return steps.word().size();
}

DerivationTree all_steps(const LoadedPoints& loaded, std::uint64_t cycles) {
    refuse_growth({&loaded, 1}, cycles);
    const auto table_of = loaded.system->cycle();
    DerivationTree tree;
    tree.words.push_back(loaded.word);
    tree.row_names.emplace_back(loaded.start == "the axiom" ? "axiom" : "polygon");
    Steps steps(loaded);
    for (std::uint64_t step = 0; step < cycles * table_of.size(); ++step) {
        steps.step(tree.steps.emplace_back());
        tree.words.push_back(steps.word());
        const auto table = table_of[step % table_of.size()];
        tree.row_names.push_back(fmt::format("step {}", step + 1));
        if (table) tree.row_names.back() += fmt::format(" ({})", loaded.system->grammar().tables[*table]);
        if (!fits_in_tree(tree.words))
            throw failure(ExitCode::Refused,
                          fmt::format("a tree shows words of at most {} modules, {} in all: step {} has more",
                                      max_tree_row, max_tree_modules, step + 1),
                          "fewer cycles, or a smaller polygon");
    }
    return tree;
}

} // namespace internode::cli
