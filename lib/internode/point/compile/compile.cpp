// SPDX-License-Identifier: MIT

#include "internode/point/compile/compile.h"

#include "internode/point/compile/cell_piece.h"
#include "internode/point/layouts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace internode {
namespace {

/// Widths of pieces, one after the other.
constexpr std::array<std::size_t, 12> sides{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

/// Why no piece could decide, seen in the grammar alone.
std::vector<ExactStop> obstacles(const PointSystem& system) {
    const PointGrammar& grammar = system.grammar();
    std::vector<ExactStop> reasons;
    const auto is_used = [&](std::optional<Symbol> letter) {
        return letter && system.layout()[to_index(*letter)].has_value();
    };
    if (is_used(branch_open(grammar))) reasons.push_back({{}, "has branches"});
    for (const PointRule& rule : grammar.rules) {
        if (rule.predecessor.size() > 1) reasons.push_back({rule.place, "has a strict predecessor of several modules"});
        if (rule.weight) reasons.push_back({rule.place, "is chosen by chance"});
    }
    for (std::size_t i = 0; i < grammar.letters.size(); ++i)
        if (grammar.letters.names()[i].front() == '?' && is_used(to_symbol(i)))
            reasons.push_back({{}, "asks its surroundings by `" + grammar.letters.names()[i] + "`"});
    return reasons;
}

/// All points of all words have one dimension.
std::optional<ExactStop> dimensions(const PointSystem& system) {
    Extent extent = 0;
    for (const auto& parameters : system.layout()) {
        if (!parameters) continue;
        for (const Extent each : *parameters) {
            if (each == 0) continue;
            if (extent != 0 && each != extent) return ExactStop{{}, "has points of several dimensions"};
            extent = each;
        }
    }
    if (extent == 0) return ExactStop{{}, "has no points"};
    return std::nullopt;
}

/// A module of the start word: its numbers exact, its points new ones.
std::optional<ExactStop> add_opaque(const ModuleTemplate& made, const PointSystem& system, std::ptrdiff_t& next,
                                    ExactWord& word) {
    ExactModule module{made.letter, {}, 0};
    const std::vector<Extent>& extents = system.layout()[to_index(made.letter)].value();
    for (std::size_t i = 0; i < extents.size(); ++i) {
        if (extents[i] > 0) {
            module.values.emplace_back(PointSum{{{next++, Rational(1)}}});
            continue;
        }
        ExactResult result = exact_value(made.arguments[i], {}, system);
        if (!result.value) return ExactStop{made.arguments[i].place, result.reason};
        module.values.emplace_back(std::get<Rational>(*std::move(result.value)));
    }
    word.push_back(std::move(module));
    return std::nullopt;
}

} // namespace

/// Tries one width of pieces after the other.
class GrammarCompiler {
public:
    GrammarCompiler(const PointSystem& system, StartWord start, const CompileLimits& limits)
        : system_(system)
        , start_(start)
        , limits_(limits)
        , input_(effective_input(system.grammar(), system.start())) {
        budget_.left = limits.work;
        if (start.points == std::size_t{0}) throw std::invalid_argument("a polygon without points");
        if (start.points && !input_) throw std::invalid_argument("a grammar without an input");
        if (!start.points && !system.grammar().axiom) throw std::invalid_argument("a grammar without an axiom");
    }

    Compilation compile() {
        Compilation result;
        result.reasons = obstacles(system_);
        if (std::optional<ExactStop> stop = dimensions(system_)) result.reasons.push_back(*std::move(stop));
        if (!result.reasons.empty()) return result;
        for (const std::size_t side : sides) {
            if (side > limits_.side) break;
            side_ = side;
            const bool done = explore();
            if (stop_) {
                result.reasons.push_back(*std::move(stop_));
                return result;
            }
            if (!done) continue;
            result.compiled = finish();
            if (result.compiled->automaton().width() <= max_row_width) return result;
            result.compiled.reset();
            result.reasons.push_back(too_wide());
            return result;
        }
        result.reasons.push_back({{}, "needs letters that lie further away with every cycle"});
        return result;
    }

private:
    struct State {
        CellPiece piece;
        std::vector<PieceChild> children;
        std::vector<std::uint32_t> states; ///< of the children
    };

    /// The start word, of many points cut down to a number whose ends do not see each other.
    std::optional<ExactWord> start_word() {
        ExactWord word;
        std::ptrdiff_t next = 0;
        const auto add = [&](const std::vector<ModuleTemplate>& part) {
            for (const ModuleTemplate& made : part)
                if (!stop_) stop_ = add_opaque(made, system_, next, word);
        };
        if (!start_.points) {
            add(*system_.grammar().axiom);
        } else {
            for (std::size_t i = 0; i < shown_points(); ++i) {
                const bool last = i + 1 == shown_points();
                add(input_->has_ends && i == 0 ? input_->first
                    : input_->has_ends && last ? input_->last
                                               : input_->each);
            }
        }
        if (stop_) return std::nullopt;
        return word;
    }

    /// Every point gives at least one module, so pieces of W modules see at most W points to each side.
    [[nodiscard]] std::size_t shown_points() const { return std::min(*start_.points, 2 * side_ + 3); }

    bool explore() {
        kinds_.emplace(system_);
        states_.clear();
        numbers_.clear();
        starts_.clear();
        const std::optional<ExactWord> word = start_word();
        if (!word) return false;
        for (std::size_t m = 0; m < word->size(); ++m)
            for (std::uint32_t slot = 0; slot < points_in((*word)[m]); ++slot)
                starts_.push_back(number(piece_of_word(*word, system_.grammar().ring, m, slot, side_, *kinds_)));
        if (starts_.empty()) stop_ = ExactStop{{}, "has no points in its first word"};
        for (std::size_t i = 0; i < states_.size() && !stop_; ++i)
            if (!expand(i)) return false;
        return !stop_;
    }

    bool expand(std::size_t i) {
        PieceChildren made = children_of(states_[i].piece, system_, *kinds_, side_, budget_);
        stop_ = std::move(made.stop);
        if (stop_ && budget_.left == 0) stop_ = ExactStop{{}, "takes too long to compile"};
        if (!made.children) return false;
        for (const PieceChild& child : *made.children) {
            const std::uint32_t state = number(child.piece);
            states_[i].states.push_back(state);
        }
        states_[i].children = *std::move(made.children);
        return true;
    }

    std::uint32_t number(const CellPiece& piece) {
        const auto [place, is_new] = numbers_.try_emplace(piece, static_cast<std::uint32_t>(states_.size()));
        if (is_new) states_.push_back({piece, {}, {}});
        if (states_.size() > limits_.states && !stop_)
            stop_ = ExactStop{{},
                              "has too many states: letters, numbers and neighbours differ in more than " +
                                  std::to_string(limits_.states) + " ways"};
        return place->second;
    }

    /// States that cannot be told apart become one.
    CompiledGrammar finish() {
        CompiledGrammar compiled;
        reach_ = reaches();
        CellRules rules;
        std::vector<CompiledGrammar::Emission> emissions;
        for (const State& state : states_) {
            emissions.push_back(emission(state.piece));
            rules.emplace_back();
            for (std::size_t c = 0; c < state.children.size(); ++c)
                rules.back().push_back({state.states[c], own_row(state.children[c])});
        }
        const std::vector<std::uint32_t> classes = equivalent_states(rules, labels(), colors(emissions));
        std::vector<bool> seen(states_.size());
        for (std::size_t i = 0; i < states_.size(); ++i) {
            if (seen[classes[i]]) continue;
            seen[classes[i]] = true;
            for (CellChild& child : rules[i]) child.state = classes[child.state];
            compiled.rules_.push_back(rules[i]);
            compiled.emissions_.push_back(emissions[i]);
            auto& around = compiled.surroundings_.emplace_back();
            for (PieceChild& child : states_[i].children) around.push_back({child.first, std::move(child.rows)});
        }
        compiled.automaton_ = std::make_shared<const CellAutomaton>(make_cell_automaton(compiled.rules_));
        compiled.kinds_ = kinds_->kinds();
        for (const ModuleKind& kind : compiled.kinds_) compiled.is_point_.push_back(kinds_->points_of(kind.letter));
        for (const Reach& reach : reach_)
            compiled.fused_width_ =
                std::max(compiled.fused_width_, static_cast<std::size_t>(reach.last - reach.first + 1));
        spread_cells(classes, compiled);
        return compiled;
    }

    /// The cells of the whole start word from those of the one that was cut down.
    void spread_cells(const std::vector<std::uint32_t>& classes, CompiledGrammar& compiled) const {
        std::vector<std::uint32_t> shown;
        for (const std::uint32_t state : starts_) shown.push_back(classes[state]);
        compiled.cells_ = shown;
        if (!start_.points || *start_.points < 2 * side_ + 3) return;
        // Whole points; each of the middle ones has as many cells.
        const std::size_t inner = cells_of(input_->each);
        const std::size_t first = cells_of(input_->has_ends ? input_->first : input_->each) + side_ * inner;
        const std::size_t more = *start_.points - shown_points();
        const auto middle = shown.begin() + static_cast<std::ptrdiff_t>(first);
        compiled.interior_ = *middle;
        compiled.cells_.assign(shown.begin(), middle);
        for (std::size_t i = 0; i < more; ++i)
            compiled.cells_.insert(compiled.cells_.end(), middle, middle + static_cast<std::ptrdiff_t>(inner));
        compiled.cells_.insert(compiled.cells_.end(), middle, shown.end());
    }

    [[nodiscard]] std::size_t cells_of(const std::vector<ModuleTemplate>& part) const {
        std::size_t cells = 0;
        for (const ModuleTemplate& made : part)
            for (const bool is_point : kinds_->points_of(made.letter)) cells += is_point ? 1 : 0;
        return cells;
    }

    [[nodiscard]] CompiledGrammar::Emission emission(const CellPiece& piece) const {
        CompiledGrammar::Emission emission{{}, piece.slot};
        if (piece.slot > 0) return emission;
        const OwnModules own = own_modules(piece, *kinds_).value();
        emission.kinds.assign(piece.kinds.begin() + static_cast<std::ptrdiff_t>(own.first),
                              piece.kinds.begin() + static_cast<std::ptrdiff_t>(own.last));
        return emission;
    }

    [[nodiscard]] static CellRow own_row(const PieceChild& child) {
        return trimmed(child.rows[static_cast<std::size_t>(-child.first)]);
    }

    [[nodiscard]] static std::vector<std::uint32_t> colors(const std::vector<CompiledGrammar::Emission>& emissions) {
        std::map<std::pair<std::vector<std::uint32_t>, std::size_t>, std::uint32_t> numbers;
        std::vector<std::uint32_t> colors;
        for (const CompiledGrammar::Emission& emission : emissions)
            colors.push_back(
                numbers.try_emplace({emission.kinds, emission.slot}, static_cast<std::uint32_t>(numbers.size()))
                    .first->second);
        return colors;
    }

    /// Which cells round a cell its descendants depend on.
    struct Reach {
        std::ptrdiff_t first = 0;
        std::ptrdiff_t last = 0;
        friend bool operator==(const Reach&, const Reach&) = default;
    };

    [[nodiscard]] std::vector<Reach> reaches() const {
        std::vector<Reach> reach(states_.size());
        for (bool changes = true; changes;) {
            changes = false;
            for (std::size_t i = 0; i < states_.size(); ++i)
                for (std::size_t c = 0; c < states_[i].children.size(); ++c)
                    changes = widen(reach[i], reach[states_[i].states[c]], states_[i].children[c]) || changes;
        }
        return reach;
    }

    static bool widen(Reach& reach, const Reach& of_child, const PieceChild& child) {
        const Reach before = reach;
        for (std::ptrdiff_t cell = of_child.first; cell <= of_child.last; ++cell) {
            const CellRow& row = child.rows[static_cast<std::size_t>(cell - child.first)];
            if (row.weights.empty()) continue;
            reach.first = std::min(reach.first, row.first);
            reach.last = std::max(reach.last, row.first + static_cast<std::ptrdiff_t>(row.weights.size()) - 1);
        }
        return !(before == reach);
    }

    /// Children with equal labels have equal rows, and equal rows of the cells that their descendants depend on.
    [[nodiscard]] std::vector<std::uint32_t> labels() const {
        CellRules all(1); // every row in question, as children of one state
        std::vector<std::vector<std::ptrdiff_t>> spans;
        for (const State& state : states_)
            for (std::size_t c = 0; c < state.children.size(); ++c) {
                const PieceChild& child = state.children[c];
                const Reach& of_child = reach_[state.states[c]];
                spans.push_back({of_child.first, of_child.last});
                for (std::ptrdiff_t cell = of_child.first; cell <= of_child.last; ++cell)
                    all[0].push_back({0, child.rows[static_cast<std::size_t>(cell - child.first)]});
            }
        const std::vector<std::uint32_t> rows = row_labels(all);
        std::map<std::pair<std::vector<std::ptrdiff_t>, std::vector<std::uint32_t>>, std::uint32_t> numbers;
        std::vector<std::uint32_t> labels;
        auto next = rows.begin();
        for (const std::vector<std::ptrdiff_t>& span : spans) {
            const auto end = next + (span[1] - span[0] + 1);
            labels.push_back(numbers
                                 .try_emplace({span, std::vector<std::uint32_t>(next, end)},
                                              static_cast<std::uint32_t>(numbers.size()))
                                 .first->second);
            next = end;
        }
        return labels;
    }

    const PointSystem& system_;
    StartWord start_;
    CompileLimits limits_;
    std::optional<PointInput> input_;
    std::size_t side_ = 1;
    ExactBudget budget_;
    std::optional<KindTable> kinds_;
    std::vector<State> states_;
    std::map<CellPiece, std::uint32_t> numbers_;
    std::vector<std::uint32_t> starts_; ///< states of the cells of the shown start word
    std::vector<Reach> reach_;          ///< of each state
    std::optional<ExactStop> stop_;
};

Compilation compile(const PointSystem& system, StartWord start, const CompileLimits& limits) {
    return GrammarCompiler(system, start, limits).compile();
}

} // namespace internode
