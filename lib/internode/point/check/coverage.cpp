// SPDX-License-Identifier: MIT
//
// Each derivation is followed step by step. A module that no rule fits is noted when a rule of the same table makes
// more points of its letter. It is noted once per context, with the first and the last number of input points that met
// it.

#include "internode/point/check/coverage.h"

#include "internode/point/matching.h"
#include "internode/point/start_word.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace internode {

namespace {

constexpr std::size_t explored_points = 12;
constexpr std::uint64_t explored_cycles = 3;
constexpr std::uint64_t max_explored_modules = 2'000; // of a word; its derivation ends there
constexpr std::uint64_t max_explored_work = 300'000;  // modules of all words together
constexpr std::size_t max_reach = 16;                 // letters of a context that are told apart
constexpr std::size_t max_contexts = 100;

using Table = std::optional<std::uint32_t>;

std::size_t point_count(std::span<const Symbol> letters, const Layout& layout) {
    std::size_t count = 0;
    for (const Symbol letter : letters) {
        const auto& parameters = layout[to_index(letter)];
        if (parameters && std::ranges::any_of(*parameters, [](Extent extent) { return extent > 0; })) ++count;
    }
    return count;
}

/// What the rules of one table say about one letter.
struct LetterRules {
    bool multiplies = false; ///< a rule makes more points of it
    std::size_t left = 0;    ///< the longest contexts
    std::size_t right = 0;
};

std::vector<LetterRules> letter_rules(const PointSystem& system, Table table) {
    const PointGrammar& grammar = system.grammar();
    std::vector<LetterRules> letters(grammar.letters.size());
    for (const std::uint32_t index : system.rules_of(table)) {
        const PointRule& rule = grammar.rules[index];
        Word successor;
        for (const ModuleTemplate& module : rule.successor) successor.push_back(module.letter);
        const std::size_t before = point_count(rule.predecessor, system.layout());
        const bool multiplies = before > 0 && point_count(successor, system.layout()) > before;
        for (const Symbol letter : rule.predecessor) {
            LetterRules& of = letters[to_index(letter)];
            if (point_count({&letter, 1}, system.layout()) > 0) of.multiplies = of.multiplies || multiplies;
            of.left = std::min(std::max(of.left, rule.left.size()), max_reach);
            of.right = std::min(std::max(of.right, rule.right.size()), max_reach);
        }
    }
    return letters;
}

class CoverageExploration {
public:
    explicit CoverageExploration(const PointSystem& system)
        : system_(system)
        , used_(system.grammar().rules.size()) {
        for (std::uint32_t table = 0; table < system.grammar().tables.size(); ++table)
            letters_.push_back(letter_rules(system, table));
        if (letters_.empty()) letters_.push_back(letter_rules(system, std::nullopt));
    }

    /// `points`: of the input; 0 for the axiom.
    void derive_from(ModuleWord word, std::size_t points) {
        points_ = points;
        multiplied_ = false;
        left_inside_ = false;
        run(std::move(word));
        if (left_inside_)
            coverage_.incomplete.push_back(points);
        else if (multiplied_)
            coverage_.complete.push_back(points);
    }

    [[nodiscard]] Coverage take() {
        for (std::uint32_t rule = 0; rule < used_.size(); ++rule)
            if (!used_[rule]) coverage_.unused.push_back(rule);
        coverage_.ends_complete = !coverage_.complete.empty() || coverage_.incomplete.empty();
        return std::move(coverage_);
    }

private:
    void run(ModuleWord word) {
        DeriveOptions options;
        options.max_modules = max_explored_modules;
        const auto cycle = system_.cycle();
        const std::uint64_t steps = explored_cycles * cycle.size();
        for (step_ = 0; step_ < steps; ++step_) {
            work_ += word.size() + 1;
            if (work_ > max_explored_work) return;
            coverage_.points = points_;
            look_at(word, cycle[step_ % cycle.size()]);
            StepRecord record;
            Derivation next = derive_step(system_, word, step_, options, record);
            note_rules(record);
            if (next.problem) return ends_with(*next.problem);
            word = std::move(next.word);
        }
    }

    /// A rule without a successor leaves no module that could tell of it: covered_modules notes where it fits.
    void note_rules(const StepRecord& record) {
        for (const auto& rule : record.rule) {
            if (!rule) continue;
            used_[*rule] = true;
            const PointRule& applied = system_.grammar().rules[*rule];
            multiplied_ = multiplied_ || applied.successor.size() > applied.predecessor.size();
        }
    }

    void ends_with(const DerivationProblem& problem) {
        const bool too_long = problem.place.bytes == 0; // no rule is at fault: the word outgrew the exploration
        if (coverage_.problem || too_long) return;
        coverage_.problem = problem;
        coverage_.problem_points = points_;
    }

    void look_at(const ModuleWord& word, Table table) {
        const WordShape shape(word.letters(), system_.grammar());
        assert(!table || *table < letters_.size());
        const std::vector<LetterRules>& letters = letters_[table ? *table : 0];
        const std::vector<bool> covered = covered_modules(shape, table);
        for (std::size_t i = 0; i < word.size(); ++i) {
            const LetterRules& rules = letters[to_index(word.letter(i))];
            if (covered[i] || !rules.multiplies) continue;
            add(StayingContext{.table = table,
                               .letter = word.letter(i),
                               .left = context(shape, i, rules.left, true),
                               .right = context(shape, i, rules.right, false),
                               .outermost = !has_point(shape, i, true) || !has_point(shape, i, false),
                               .smallest = points_,
                               .largest = points_,
                               .step = step_,
                               .module = i});
        }
    }

    /// The modules that the letters of some rule fit.
    [[nodiscard]] std::vector<bool> covered_modules(const WordShape& shape, Table table) {
        std::vector<bool> covered(shape.size());
        std::vector<std::size_t> modules;
        for (std::size_t i = 0; i < shape.size(); ++i)
            for (const std::uint32_t index : system_.rules_of(table)) {
                const PointRule& rule = system_.grammar().rules[index];
                if (rule.predecessor.front() != shape.letter(i)) continue;
                if (covered[i] && rule.predecessor.size() == 1 && !rule.successor.empty()) continue;
                if (!shape.fits(rule, i, modules)) continue;
                if (rule.successor.empty()) used_[index] = true;
                for (std::size_t k = 0; k < rule.predecessor.size(); ++k) covered[modules[rule.left.size() + k]] = true;
            }
        return covered;
    }

    [[nodiscard]] static Word context(const WordShape& shape, std::size_t i, std::size_t reach, bool left) {
        Word letters;
        std::optional<std::size_t> at = i;
        while (letters.size() < reach && (at = left ? shape.before(*at) : shape.after(*at)))
            letters.push_back(shape.letter(*at));
        if (left) std::ranges::reverse(letters);
        return letters;
    }

    /// Whether a module with a point stands further on along the axis; a ring has no end.
    [[nodiscard]] bool has_point(const WordShape& shape, std::size_t i, bool left) const {
        if (system_.grammar().ring) return true;
        std::optional<std::size_t> at = i;
        while ((at = left ? shape.before(*at) : shape.after(*at))) {
            const Symbol letter = shape.letter(*at);
            if (point_count({&letter, 1}, system_.layout()) > 0) return true;
        }
        return false;
    }

    void add(StayingContext context) {
        left_inside_ = left_inside_ || !context.outermost;
        const auto same = std::ranges::find_if(coverage_.staying, [&](const StayingContext& known) {
            return known.table == context.table && known.letter == context.letter && known.left == context.left &&
                   known.right == context.right && known.outermost == context.outermost;
        });
        if (same != coverage_.staying.end())
            same->largest = context.largest;
        else if (coverage_.staying.size() < max_contexts)
            coverage_.staying.push_back(std::move(context));
    }

    const PointSystem& system_;
    std::vector<std::vector<LetterRules>> letters_; ///< what the rules say of each letter, by table
    std::vector<bool> used_;
    std::size_t points_ = 0;
    std::uint64_t step_ = 0;
    std::uint64_t work_ = 0;
    bool multiplied_ = false;  ///< the derivation at hand has made points of points
    bool left_inside_ = false; ///< it has met a point that stays inside a word
    Coverage coverage_;
};

/// Points in no special position, and none with a last coordinate of 0: rational curves divide by it.
std::vector<double> some_polygon(std::size_t points, std::size_t dimension) {
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < points; ++i)
        for (std::size_t c = 0; c < dimension; ++c)
            coordinates.push_back(c == 0 ? static_cast<double>(i) : static_cast<double>((i * i * (c + 1)) % 7 + 1));
    return coordinates;
}

} // namespace

Coverage coverage(const PointSystem& system) {
    const PointGrammar& grammar = system.grammar();
    const bool axiom = grammar.axiom && system.start() != PointStart::Input;
    const bool input = system.start() != PointStart::Axiom && (grammar.input || !axiom);
    CoverageExploration exploration(system);
    if (axiom) exploration.derive_from(axiom_word(system), 0);
    if (input)
        for (std::size_t points = 1; points <= explored_points; ++points)
            exploration.derive_from(input_word(system, some_polygon(points, system.dimension())), points);
    Coverage result = exploration.take();
    result.cycles = explored_cycles;
    return result;
}

} // namespace internode
