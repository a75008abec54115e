// SPDX-License-Identifier: MIT
//
// Steps and passes are one rewriting (point/rewriting.h) with other rules: a RewritingTask says which, how the ring is
// turned and where the draws come from. The environment is asked before each.

#include "internode/point/interpreter.h"

#include "internode/point/growth.h"
#include "internode/point/rewriting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

/// Where the number in a message would not be read any more.
constexpr std::uint64_t largest_told_length = 1'000'000'000'000'000'000;

/// The draws of interpretation passes are not those of any step.
constexpr std::uint64_t pass_stream = std::uint64_t{1} << 63U;

/// Which letters are query modules with parameters to be filled.
std::vector<bool> query_letters(const PointGrammar& grammar) {
    std::vector<bool> asked;
    for (std::size_t i = 0; i < grammar.letters.size(); ++i)
        asked.push_back(grammar.letters.name(to_symbol(i)).starts_with('?') && grammar.arity[i] > 0);
    return asked;
}

/// The environment's answers, put into the word.
std::optional<DerivationProblem> ask(const PointSystem& system, const Query& query, ModuleWord& word) {
    if (!query) return std::nullopt;
    const std::vector<bool> asked = query_letters(system.grammar());
    std::vector<double> answer;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (!asked[to_index(word.letter(i))]) continue;
        const std::span<double> values = word.values(i);
        answer.assign(values.begin(), values.end());
        if (!query(word, i, answer)) continue;
        if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
            return DerivationProblem{{},
                                     fmt::format("the query `{}`, module {}, got a value that is not finite",
                                                 letter_text(system.grammar(), word.letter(i)), i + 1),
                                     ""};
        std::ranges::copy(answer, values.begin());
    }
    return std::nullopt;
}

/// The ring read from its module number `first` on.
ModuleWord turned(const ModuleWord& word, std::size_t first) {
    assert(first < word.size());
    ModuleWord result;
    result.reserve(word.size(), word.value_count());
    for (std::size_t k = 0; k < word.size(); ++k) {
        const std::size_t i = (first + k) % word.size();
        result.push_back(word.letter(i), word.values(i));
    }
    return result;
}

/// A step or a pass after the environment has been asked.
Derivation rewrite_asked(const RewritingTask& task, ModuleWord word, const DeriveOptions& options, StepRecord* record) {
    if (std::optional<DerivationProblem> problem = ask(task.system, options.query, word))
        return {std::move(word), std::move(problem), 0};
    if (task.rotation == 0) return rewrite(task, std::move(word), options, record);
    Derivation made = rewrite(task, turned(word, static_cast<std::size_t>(task.rotation)), options, record);
    if (made.problem) made.word = std::move(word);
    return made;
}

/// `from`: the word and what has been spent on it.
Derivation step_of(const PointSystem& system, Derivation from, std::uint64_t step, const DeriveOptions& options,
                   StepRecord* record) {
    ModuleWord& word = from.word;
    if (system.cycle().empty()) return {std::move(word), std::nullopt, 0};
    const std::uint64_t in_cycle = step % system.cycle().size();
    RewritingTask task{.system = system, .rules = system.grammar().rules};
    task.spent = from.work;
    task.table = system.cycle()[static_cast<std::size_t>(in_cycle)].value_or(0);
    task.stream = step;
    if (in_cycle == 0 && !word.empty()) {
        if (system.grammar().ring)
            task.rotation = options.phase % word.size();
        else
            task.first_pair = options.phase;
    }
    return rewrite_asked(task, std::move(word), options, record);
}

/// Interpretation pass number `pass`, when so much work is done already.
Derivation pass_of(const PointSystem& system, ModuleWord word, std::size_t pass, std::uint64_t spent,
                   const DeriveOptions& options) {
    assert(pass < system.grammar().interpretations.size());
    RewritingTask task{.system = system, .rules = system.grammar().interpretations[pass]};
    task.set = pass + 1;
    task.stream = pass_stream + pass;
    task.spent = spent;
    return rewrite_asked(task, std::move(word), options, nullptr);
}

/// Takes the next word; whether the derivation goes on.
bool follow(Derivation& done, Derivation next) {
    done.work += next.work;
    done.word = std::move(next.word);
    done.problem = std::move(next.problem);
    return !done.problem;
}

std::optional<DerivationProblem> too_long(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                                          std::uint64_t limit) {
    const std::optional<std::uint64_t> length = predicted_length(system, word, cycles, limit);
    if (!length || *length <= limit) return std::nullopt;
    const std::optional<std::uint64_t> exact = predicted_length(system, word, cycles, largest_told_length);
    const std::string told = !exact                         ? fmt::format("more than {}", limit)
                             : *exact > largest_told_length ? fmt::format("more than {}", largest_told_length)
                                                            : fmt::format("{}", *exact);
    return DerivationProblem{{},
                             fmt::format("after {} cycle{} the word would have {} modules; {} are allowed", cycles,
                                         cycles == 1 ? "" : "s", told, limit),
                             "fewer cycles, or a larger limit of modules"};
}

} // namespace

Derivation derive_step(const PointSystem& system, const ModuleWord& word, std::uint64_t step,
                       const DeriveOptions& options) {
    return step_of(system, {word, std::nullopt, 0}, step, options, nullptr);
}

Derivation derive_step(const PointSystem& system, const ModuleWord& word, std::uint64_t step,
                       const DeriveOptions& options, StepRecord& record) {
    return step_of(system, {word, std::nullopt, 0}, step, options, &record);
}

Derivation derive(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                  const DeriveOptions& options) {
    Derivation done{word, too_long(system, word, cycles, options.max_modules), 0};
    if (done.problem || system.cycle().empty()) return done;
    // Nothing comes of an empty word, however many cycles are left.
    for (std::uint64_t cycle = 0; cycle < cycles && !done.word.empty(); ++cycle)
        for (std::uint64_t k = 0; k < system.cycle().size(); ++k) {
            const std::uint64_t step = cycle * system.cycle().size() + k;
            Derivation from{std::move(done.word), std::nullopt, done.work};
            if (!follow(done, step_of(system, std::move(from), step, options, nullptr))) return done;
        }
    return done;
}

Derivation interpret(const PointSystem& system, const ModuleWord& word, const DeriveOptions& options) {
    Derivation done{word, std::nullopt, 0};
    for (std::size_t pass = 0; pass < system.grammar().interpretations.size(); ++pass)
        if (!follow(done, pass_of(system, std::move(done.word), pass, done.work, options))) return done;
    return done;
}

Derivation interpret_pass(const PointSystem& system, const ModuleWord& word, std::size_t pass,
                          const DeriveOptions& options) {
    return pass_of(system, word, pass, 0, options);
}

} // namespace internode
