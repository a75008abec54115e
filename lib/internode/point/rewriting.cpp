// SPDX-License-Identifier: MIT
//
// From left to right: the first rule of the letter that fits and whose condition holds, or a draw among those with
// weights. Its successor is written, and as many modules are passed as its strict predecessor has. Beyond the limit the
// new word is counted and not stored, so that a message can tell its length.

#include "internode/point/rewriting.h"

#include "internode/point/limits.h"
#include "internode/point/matching.h"
#include "internode/point/module_writer.h"
#include "internode/point/random_draw.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace internode {

namespace {

class Rewriting {
public:
    Rewriting(const RewritingTask& task, const ModuleWord& word, const DeriveOptions& options, StepRecord* record)
        : task_(task)
        , set_(task.system.programs().sets[task.set])
        , word_(word)
        , options_(options)
        , record_(record)
        , shape_(word.letters(), task.system.grammar())
        , writer_(task.system.programs().functions) {
        assert(task.rules.size() == set_.rules.size() && task.table < set_.by_letter.size());
    }

    Derivation run() {
        if (record_ != nullptr) *record_ = {};
        std::size_t i = 0;
        while (i < word_.size() && !problem_) {
            i += rewrite_at(i);
            if (task_.spent + work() > options_.max_work) refuse_work();
        }
        if (!problem_ && length_ > options_.max_modules) refuse_length();
        return {std::move(result_), std::move(problem_), work()};
    }

private:
    /// How many modules of the old word that was.
    std::size_t rewrite_at(std::size_t i) {
        const std::optional<std::uint32_t> index = choose(i);
        if (problem_) return 1;
        if (!index) {
            keep(i);
            return 1;
        }
        apply(*index, i);
        return task_.rules[*index].predecessor.size();
    }

    /// The rule for the module at i; modules_ and formals_ are then its own.
    std::optional<std::uint32_t> choose(std::size_t i) {
        for (const std::uint32_t index : candidates(i))
            if (applies(index, i)) return set_.rules[index].weight ? draw(index, i) : index;
        return std::nullopt;
    }

    [[nodiscard]] const std::vector<std::uint32_t>& candidates(std::size_t i) const {
        return set_.by_letter[task_.table][to_index(word_.letter(i))];
    }

    bool applies(std::uint32_t index, std::size_t i) {
        const PointRule& rule = task_.rules[index];
        if (rule.predecessor.size() > 1 && i < task_.first_pair) return false;
        if (!shape_.fits(rule, i, modules_, &compared_)) return false;
        gather(rule);
        const std::optional<Program>& condition = set_.rules[index].condition;
        return !condition || writer_.number(*condition, formals_) != 0;
    }

    void gather(const PointRule& rule) {
        assert(modules_.size() == rule.left.size() + rule.predecessor.size() + rule.right.size());
        formals_.clear();
        if (rule.formals.empty()) return;
        for (const std::size_t module : modules_) {
            const std::span<const double> values = word_.values(module);
            formals_.insert(formals_.end(), values.begin(), values.end());
        }
        compared_ += formals_.size();
    }

    /// One of the matching rules with a weight, from `first` on, and a strict predecessor as long.
    std::optional<std::uint32_t> draw(std::uint32_t first, std::size_t i) {
        const std::size_t length = task_.rules[first].predecessor.size();
        drawn_.clear();
        double total = 0;
        for (const std::uint32_t index : candidates(i)) {
            if (index < first || !set_.rules[index].weight || task_.rules[index].predecessor.size() != length) continue;
            if (!applies(index, i)) continue;
            const double weight = writer_.number(*set_.rules[index].weight, formals_);
            total += weight;
            if (!(weight > 0) || !std::isfinite(total)) {
                refuse_weight(index, weight);
                return std::nullopt;
            }
            drawn_.push_back({index, total});
        }
        assert(!drawn_.empty() && "the first rule that fits is drawn among the others");
        const double target = uniform_draw(options_.seed, task_.stream, i) * total;
        std::size_t k = 0;
        while (k + 1 < drawn_.size() && drawn_[k].up_to <= target) ++k;
        [[maybe_unused]] const bool still = applies(drawn_[k].rule, i);
        assert(still);
        return drawn_[k].rule;
    }

    void keep(std::size_t i) {
        if (i >= task_.first_pair && set_.begins_several[task_.table][to_index(word_.letter(i))]) {
            refuse_left_over(i);
            return;
        }
        if (make_room(1)) result_.push_back(word_.letter(i), word_.values(i));
        if (record_ != nullptr) note(i, std::nullopt);
    }

    void apply(std::uint32_t index, std::size_t i) {
        const std::vector<ModulePrograms>& successor = set_.rules[index].successor;
        if (!make_room(successor.size())) return;
        for (std::size_t k = 0; k < successor.size(); ++k) {
            if (const std::optional<std::size_t> refused = writer_.write(successor[k], formals_, result_)) {
                refuse_value(index, k, *refused, i);
                return;
            }
            if (record_ != nullptr) note(i, index);
        }
    }

    /// Whether so many modules more may be stored; they are counted in any case.
    bool make_room(std::uint64_t modules) {
        length_ += modules;
        if (result_.value_count() / values_per_module > options_.max_modules) refuse_values();
        return length_ <= options_.max_modules && !problem_;
    }

    [[nodiscard]] std::size_t number_of(std::size_t module) const {
        return static_cast<std::size_t>((module + task_.rotation) % word_.size());
    }

    void note(std::size_t i, std::optional<std::uint32_t> index) {
        record_->parent.push_back(number_of(i));
        record_->rule.push_back(index);
        std::vector<std::size_t>& read = record_->read.emplace_back();
        if (!index) return;
        const PointRule& rule = task_.rules[*index];
        for (std::size_t k = 0; k < modules_.size(); ++k)
            if (k < rule.left.size() || k >= rule.left.size() + rule.predecessor.size())
                read.push_back(number_of(modules_[k]));
    }

    [[nodiscard]] std::uint64_t work() const { return compared_ + length_ + writer_.work(); }

    [[nodiscard]] std::string_view name_of(Symbol letter) const { return letter_text(task_.system.grammar(), letter); }
    [[nodiscard]] std::string name_of(const PointRule& rule) const {
        return rule.label.empty() ? fmt::format("this rule of `{}`", name_of(rule.predecessor.front()))
                                  : fmt::format("rule `{}`", rule.label);
    }

    void refuse_length() {
        problem_ = {{},
                    fmt::format("the word would have {} modules, more than {}", length_, options_.max_modules),
                    "fewer cycles, or a larger limit of modules"};
    }
    void refuse_values() {
        problem_ = {
            {},
            fmt::format("the word would have more than {} numbers", options_.max_modules * values_per_module),
            fmt::format("{} for each of the {} modules that are allowed", values_per_module, options_.max_modules)};
    }
    void refuse_work() {
        problem_ = {{},
                    fmt::format("more than {} letters compared and numbers computed", options_.max_work),
                    "long contexts and long words together"};
    }
    void refuse_weight(std::uint32_t index, double weight) {
        const PointRule& rule = task_.rules[index];
        problem_ = {rule.weight->place,
                    weight > 0 ? "the weights of the rules that match add up to infinity"
                               : fmt::format("the weight of {} is not a number above 0", name_of(rule)),
                    ""};
    }
    void refuse_value(std::uint32_t index, std::size_t module, std::size_t argument, std::size_t i) {
        const PointRule& rule = task_.rules[index];
        const ModuleTemplate& made = rule.successor[module];
        problem_ = {made.arguments[argument].place,
                    fmt::format("{} gives `{}` a parameter that is not finite, at module {}", name_of(rule),
                                name_of(made.letter), number_of(i) + 1),
                    "a division by zero, the root of a negative number, or a number beyond 1.8e308"};
    }
    void refuse_left_over(std::size_t i) {
        const Symbol letter = word_.letter(i);
        const PointRule* several = nullptr;
        for (const std::uint32_t index : candidates(i))
            if (several == nullptr && task_.rules[index].predecessor.size() > 1) several = &task_.rules[index];
        assert(several != nullptr);
        problem_ = {several->place,
                    fmt::format("module {}, `{}`, is left over: {} needs {} modules in a row that are not yet "
                                "rewritten",
                                number_of(i) + 1, name_of(letter), name_of(*several), several->predecessor.size()),
                    "another phase, another number of points, or rules for what is left over"};
    }

    struct Drawn {
        std::uint32_t rule = 0;
        double up_to = 0; ///< the weights up to this rule's, added in order
    };

    const RewritingTask& task_;
    const RuleSetPrograms& set_;
    const ModuleWord& word_;
    const DeriveOptions& options_;
    StepRecord* record_;
    WordShape shape_;
    ModuleWriter writer_;
    ModuleWord result_;
    std::optional<DerivationProblem> problem_;
    std::uint64_t length_ = 0;   ///< modules of the new word, whether it is stored or not
    std::uint64_t compared_ = 0; ///< letters and values looked at
    std::vector<std::size_t> modules_;
    std::vector<double> formals_;
    std::vector<Drawn> drawn_;
};

} // namespace

Derivation rewrite(const RewritingTask& task, ModuleWord word, const DeriveOptions& options, StepRecord* record) {
    Derivation made = Rewriting(task, word, options, record).run();
    if (made.problem) made.word = std::move(word);
    return made;
}

} // namespace internode
