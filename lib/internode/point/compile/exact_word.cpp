// SPDX-License-Identifier: MIT
//
// One Rewriter serves two notions of place: in a whole word a rule fits or not, in a piece it may be unknown. A rule
// that may fit ends the search, for which rule comes first would depend on what lies beyond. A piece is settled
// outwards from the modules that must be.

#include "internode/point/compile/exact_word.h"

#include "internode/point/effective_input.h"
#include "internode/point/matching.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <stdexcept>

namespace internode {
namespace {

enum class Fit { No, Yes, Unknown };

std::vector<Symbol> letters_of(const ExactWord& word) {
    std::vector<Symbol> letters;
    letters.reserve(word.size());
    for (const ExactModule& module : word) letters.push_back(module.letter);
    return letters;
}

/// Where rules fit in a whole word.
class WholeWord {
public:
    WholeWord(const ExactWord& word, const PointGrammar& grammar)
        : letters_(letters_of(word))
        , shape_(letters_, grammar) {}

    [[nodiscard]] Fit fit(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const {
        return shape_.fits(rule, i, modules) ? Fit::Yes : Fit::No;
    }

private:
    std::vector<Symbol> letters_;
    WordShape shape_;
};

/// Where rules fit in a piece, without brackets.
class Piece {
public:
    Piece(const ExactWord& word, PieceSides sides)
        : letters_(letters_of(word))
        , sides_(sides) {}

    /// `modules`: of the rule's formals, where it fits.
    [[nodiscard]] Fit fit(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const {
        assert(i < letters_.size());
        bool is_certain = true;
        modules.clear();
        auto at = static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(rule.left.size());
        for (const auto* part : {&rule.left, &rule.predecessor, &rule.right})
            for (const Symbol letter : *part) {
                const Fit fit = compare(letter, at);
                if (fit == Fit::No) return Fit::No;
                is_certain = is_certain && fit == Fit::Yes;
                modules.push_back(static_cast<std::size_t>(at++));
            }
        return is_certain ? Fit::Yes : Fit::Unknown;
    }

private:
    /// One letter of a rule with the module that stands there, inside the piece or beyond.
    [[nodiscard]] Fit compare(Symbol letter, std::ptrdiff_t at) const {
        if (at < 0) return sides_.left_open ? Fit::Unknown : Fit::No;
        if (at >= std::ssize(letters_)) return sides_.right_open ? Fit::Unknown : Fit::No;
        return letters_[static_cast<std::size_t>(at)] == letter ? Fit::Yes : Fit::No;
    }

    std::vector<Symbol> letters_;
    PieceSides sides_;
};

/// A module of a successor, an input or an axiom.
std::variant<ExactModule, ExactStop> made_of(const ModuleTemplate& made, std::span<const ExactValue> formals,
                                             const PointSystem& system) {
    ExactModule module{made.letter, {}, 0};
    for (const Expression& argument : made.arguments) {
        ExactResult result = exact_value(argument, formals, system.scope());
        if (!result.value) return ExactStop{argument.place, result.reason};
        module.values.push_back(*std::move(result.value));
    }
    return module;
}

std::uint64_t cost_of(const ExactModule& module) {
    std::uint64_t cost = 1;
    for (const ExactValue& value : module.values)
        if (const PointSum* sum = std::get_if<PointSum>(&value))
            for (const auto& term : sum->terms) cost += 1 + mpz_sizeinbase(term.second.get_den_mpz_t(), 2) / 64;
    return cost;
}

/// Chooses rules and writes successors.
template<typename Word>
class Rewriter {
public:
    Rewriter(const PointSystem& system, const ExactWord& word, const Word& place, std::optional<std::uint32_t> table,
             ExactBudget& budget)
        : system_(system)
        , word_(word)
        , place_(place)
        , budget_(budget)
        , rules_(system.rules_of(table))
        , is_pseudo_(system.is_pseudo(table)) {}

    /// What becomes of module i, and how many modules it takes with it. Not settled: no value, and no stop.
    struct Successor {
        ExactWord modules;
        std::size_t taken = 1;
    };
    std::optional<Successor> successor(std::size_t i) {
        assert(i < word_.size());
        std::vector<std::size_t> modules;
        for (const std::uint32_t index : rules_) {
            const PointRule& rule = system_.grammar().rules[index];
            const Fit fit = place_.fit(rule, i, modules);
            if (fit == Fit::No) continue;
            if (fit == Fit::Unknown) return std::nullopt;
            const std::vector<ExactValue> formals = formals_of(modules);
            const std::optional<bool> holds = condition(rule, formals);
            if (!holds) return std::nullopt;
            if (!*holds) continue;
            if (rule.weight) return stop(rule.place, "is chosen by chance");
            return rewritten(rule, formals, i);
        }
        if (is_pseudo_ && begins_predecessor(word_[i].letter)) return stop({}, "leaves a module over");
        ExactModule same = word_[i];
        same.parent = i;
        if (!spend(same)) return std::nullopt;
        return Successor{{std::move(same)}, 1};
    }

    [[nodiscard]] const std::optional<ExactStop>& stop() const { return stop_; }

private:
    std::nullopt_t stop(SourcePlace place, std::string reason) {
        stop_ = ExactStop{place, std::move(reason)};
        return std::nullopt;
    }

    bool spend(const ExactModule& module) {
        const std::uint64_t cost = cost_of(module);
        if (cost > budget_.left) stop({}, "needs too much exact arithmetic");
        budget_.left -= std::min(cost, budget_.left);
        return !stop_;
    }

    [[nodiscard]] bool begins_predecessor(Symbol letter) const {
        return std::ranges::any_of(rules_, [&](std::uint32_t index) {
            const PointRule& rule = system_.grammar().rules[index];
            return rule.predecessor.size() > 1 && rule.predecessor.front() == letter;
        });
    }

    [[nodiscard]] std::vector<ExactValue> formals_of(const std::vector<std::size_t>& modules) const {
        std::vector<ExactValue> formals;
        for (const std::size_t module : modules)
            formals.insert(formals.end(), word_[module].values.begin(), word_[module].values.end());
        return formals;
    }

    std::optional<bool> condition(const PointRule& rule, const std::vector<ExactValue>& formals) {
        if (!rule.condition) return true;
        const ExactResult result = exact_value(*rule.condition, formals, system_.scope());
        if (!result.value) return stop(rule.condition->place, "has a condition that " + result.reason);
        return std::get<Rational>(*result.value) != 0;
    }

    std::optional<Successor> rewritten(const PointRule& rule, const std::vector<ExactValue>& formals, std::size_t i) {
        Successor successor{{}, rule.predecessor.size()};
        for (const ModuleTemplate& made : rule.successor) {
            std::variant<ExactModule, ExactStop> module = made_of(made, formals, system_);
            if (const ExactStop* reason = std::get_if<ExactStop>(&module)) return stop(reason->place, reason->reason);
            successor.modules.push_back(std::get<ExactModule>(std::move(module)));
            successor.modules.back().parent = i;
            if (!spend(successor.modules.back())) return std::nullopt;
        }
        return successor;
    }

    const PointSystem& system_;
    const ExactWord& word_;
    const Word& place_;
    ExactBudget& budget_;
    std::span<const std::uint32_t> rules_;
    bool is_pseudo_;
    std::optional<ExactStop> stop_;
};

void append(ExactWord& word, ExactWord modules) {
    std::ranges::move(modules, std::back_inserter(word));
}

bool is_query(Symbol letter, const PointGrammar& grammar) {
    return grammar.letters.name(letter).front() == '?';
}

std::optional<ExactStop> query_in(const ExactWord& word, const PointSystem& system) {
    for (const ExactModule& module : word)
        if (is_query(module.letter, system.grammar())) return ExactStop{{}, "asks its surroundings"};
    return std::nullopt;
}

/// Appends the modules that a point becomes.
std::optional<ExactStop> add_point(const std::vector<ModuleTemplate>& part, std::size_t index,
                                   const PointSystem& system, ExactWord& word) {
    const std::vector<ExactValue> formals{PointSum{{{static_cast<std::ptrdiff_t>(index), Rational(1)}}}};
    for (const ModuleTemplate& made : part) {
        auto module = made_of(made, formals, system);
        if (const ExactStop* stop = std::get_if<ExactStop>(&module)) return *stop;
        word.push_back(std::get<ExactModule>(std::move(module)));
    }
    return std::nullopt;
}

} // namespace

std::variant<ExactWord, ExactStop> exact_step(const PointSystem& system, const ExactWord& word,
                                              std::optional<std::uint32_t> table, ExactBudget& budget) {
    if (const std::optional<ExactStop> query = query_in(word, system)) return *query;
    const WholeWord place(word, system.grammar());
    Rewriter<WholeWord> rewriter(system, word, place, table, budget);
    ExactWord next;
    for (std::size_t i = 0; i < word.size();) {
        auto successor = rewriter.successor(i);
        if (!successor) return rewriter.stop().value();
        append(next, std::move(successor->modules));
        i += successor->taken;
    }
    return next;
}

PieceStep exact_piece_step(const PointSystem& system, const ExactWord& piece, PieceSides sides, std::size_t first,
                           std::size_t last, std::optional<std::uint32_t> table, ExactBudget& budget) {
    assert(first <= last && last <= piece.size());
    const Piece place(piece, sides);
    Rewriter<Piece> rewriter(system, piece, place, table, budget);
    std::vector<ExactWord> successors(piece.size());
    // Outwards from the modules that must be settled.
    std::size_t begin = first;
    std::size_t end = first;
    const auto settle = [&](std::size_t i) {
        auto successor = rewriter.successor(i);
        if (successor) successors[i] = std::move(successor->modules);
        return successor.has_value();
    };
    while (end < piece.size() && settle(end)) ++end;
    PieceStep step;
    step.stop = rewriter.stop();
    if (step.stop || end < last) return step;
    while (begin > 0 && settle(begin - 1)) --begin;
    step.stop = rewriter.stop();
    if (step.stop) return step;
    step.word.emplace();
    step.sides = {sides.left_open || begin > 0, sides.right_open || end < piece.size()};
    step.first = begin;
    step.last = end;
    for (std::size_t i = begin; i < end; ++i) append(*step.word, std::move(successors[i]));
    return step;
}

std::variant<ExactWord, ExactStop> exact_input(const PointSystem& system, std::size_t count) {
    if (count == 0) throw std::invalid_argument("a polygon without points");
    const std::optional<PointInput> input = effective_input(system.grammar(), system.start());
    if (!input) throw std::invalid_argument("a grammar without an input");
    ExactWord word;
    for (std::size_t i = 0; i < count; ++i)
        if (std::optional<ExactStop> stop = add_point(input_part(*input, i, count), i, system, word))
            return *std::move(stop);
    return word;
}

std::variant<ExactWord, ExactStop> exact_axiom(const PointSystem& system) {
    if (!system.grammar().axiom) throw std::invalid_argument("a grammar without an axiom");
    ExactWord word;
    for (const ModuleTemplate& made : *system.grammar().axiom) {
        auto module = made_of(made, {}, system);
        if (const ExactStop* stop = std::get_if<ExactStop>(&module)) return *stop;
        word.push_back(std::get<ExactModule>(std::move(module)));
    }
    return word;
}

std::variant<RationalMatrix, ExactStop> point_matrix(const PointSystem& system, std::size_t count,
                                                     std::uint64_t cycles) {
    auto word = exact_input(system, count);
    ExactBudget budget;
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle)
        for (const std::optional<std::uint32_t> table : system.cycle()) {
            if (const ExactStop* stop = std::get_if<ExactStop>(&word)) return *stop;
            word = exact_step(system, std::get<ExactWord>(word), table, budget);
        }
    if (const ExactStop* stop = std::get_if<ExactStop>(&word)) return *stop;
    RationalMatrix matrix;
    matrix.columns = count;
    for (const ExactModule& module : std::get<ExactWord>(word))
        for (const ExactValue& value : module.values)
            if (const PointSum* sum = std::get_if<PointSum>(&value)) {
                RationalRow& row = matrix.rows.emplace_back();
                for (const auto& term : sum->terms) row.push_back({static_cast<std::size_t>(term.first), term.second});
            }
    return matrix;
}

} // namespace internode
