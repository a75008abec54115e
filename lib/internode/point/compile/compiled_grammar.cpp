// SPDX-License-Identifier: MIT
//
// Several cycles are fused from the last to the first. What a child becomes later stands as rows over the cells round
// it; these cells are rows over the parents, and the product is a row of one cycle more. Only states that are met in a
// cycle are carried through it.

#include "internode/point/compile/compiled_grammar.h"

#include "internode/algebra/double_double.h"
#include "internode/stencil/coordinate_buffer.h"
#include "internode/stencil/fused_stencils.h"
#include "internode/stencil/kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace internode {
namespace {

/// A weight below this cannot be seen in a sum of products; it is what is left of an exact 0.
constexpr double smallest_weight = 0x1p-80;
/// Weights larger than this have lost the bits that make the rounded rows right.
constexpr double largest_weight = 0x1p40;

/// A row over consecutive cells, in 106 bits.
struct PairRow {
    std::ptrdiff_t first = 0;
    std::vector<DoubleDouble> weights;
};

PairRow to_pairs(const CellRow& row) {
    PairRow pairs{row.first, {}};
    for (const Number& weight : row.weights) pairs.weights.push_back(to_double_double(weight));
    return pairs;
}

/// sum += factor row.
void add(PairRow& sum, DoubleDouble factor, const PairRow& row) {
    if (row.weights.empty()) return;
    if (sum.weights.empty()) sum.first = row.first;
    if (row.first < sum.first) {
        sum.weights.insert(sum.weights.begin(), static_cast<std::size_t>(sum.first - row.first), DoubleDouble{});
        sum.first = row.first;
    }
    const auto place = static_cast<std::size_t>(row.first - sum.first);
    sum.weights.resize(std::max(sum.weights.size(), place + row.weights.size()));
    for (std::size_t i = 0; i < row.weights.size(); ++i)
        sum.weights[place + i] = sum.weights[place + i] + factor * row.weights[i];
}

/// What a state becomes after some cycles.
struct Descendants {
    std::vector<std::uint32_t> states;
    std::vector<PairRow> rows;
};

/// The part of a row between its outer zeros.
PairRow without_zeros(PairRow row) {
    const auto is_zero = [](DoubleDouble weight) { return std::abs(weight.hi) < smallest_weight; };
    while (!row.weights.empty() && is_zero(row.weights.back())) row.weights.pop_back();
    const auto first = std::ranges::find_if_not(row.weights, is_zero);
    row.first += first - row.weights.begin();
    row.weights.erase(row.weights.begin(), first);
    return row;
}

/// Where the rows of a state lie together, and how wide that is.
struct Span {
    std::ptrdiff_t first = 0;
    std::size_t width = 0;
};

Span span_of(const Descendants& state) {
    std::optional<Span> all;
    for (const PairRow& row : state.rows) {
        if (row.weights.empty()) continue;
        const Span before = all.value_or(Span{row.first, 0});
        const auto width = static_cast<std::ptrdiff_t>(before.width);
        const std::ptrdiff_t end =
            std::max(before.first + width, row.first + static_cast<std::ptrdiff_t>(row.weights.size()));
        all = Span{std::min(before.first, row.first), 0};
        all->width = static_cast<std::size_t>(end - all->first);
    }
    return all.value_or(Span{});
}

/// Writes a row at its place; false when it is not precise.
bool append_row(const PairRow& row, std::ptrdiff_t offset, FusedStencils& table) {
    const std::size_t start = table.weights.size();
    table.weights.resize(start + table.width);
    for (std::size_t k = 0; k < row.weights.size(); ++k) {
        const double weight = row.weights[k].hi;
        if (!(std::abs(weight) <= largest_weight)) return false;
        assert(row.first >= offset);
        const auto place = static_cast<std::size_t>(row.first - offset);
        assert(place + row.weights.size() <= table.width);
        table.weights[start + place + k] = std::abs(weight) < smallest_weight ? 0 : weight;
    }
    return true;
}

/// The table of descendants as the kernels want it; none when a row is too wide or not precise.
std::optional<FusedStencils> table_of(const std::vector<Descendants>& descendants, int cycles) {
    FusedStencils table;
    table.steps = cycles;
    for (const Descendants& state : descendants) {
        const Span span = span_of(state);
        table.offset.push_back(static_cast<std::int32_t>(span.first));
        table.width = std::max(table.width, span.width);
    }
    if (table.width > max_row_width) return std::nullopt;
    for (std::size_t state = 0; state < descendants.size(); ++state) {
        table.first_row.push_back(static_cast<std::uint32_t>(table.descendants.size()));
        table.descendants.insert(table.descendants.end(), descendants[state].states.begin(),
                                 descendants[state].states.end());
        for (const PairRow& row : descendants[state].rows)
            if (!append_row(row, table.offset[state], table)) return std::nullopt;
    }
    table.first_row.push_back(static_cast<std::uint32_t>(table.descendants.size()));
    return table;
}

/// The states of the children of some states.
std::vector<bool> children_of(const std::vector<bool>& states, const CellRules& rules) {
    std::vector<bool> children(states.size());
    for (std::size_t state = 0; state < states.size(); ++state)
        if (states[state])
            for (const CellChild& child : rules[state]) children[child.state] = true;
    return children;
}

/// The exact rows of one cycle, rounded once.
FusedStencils one_cycle(const CellAutomaton& automaton, const std::vector<bool>& wanted) {
    assert(wanted.size() == automaton.state_count());
    FusedStencils table;
    table.width = automaton.width();
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        table.first_row.push_back(static_cast<std::uint32_t>(table.descendants.size()));
        table.offset.push_back(static_cast<std::int32_t>(automaton.offset(state)));
        if (!wanted[state]) continue;
        for (const CellAutomaton::Child& child : automaton.children(state)) {
            table.descendants.push_back(child.state);
            const auto row = automaton.weights(child.row);
            table.weights.insert(table.weights.end(), row.begin(), row.end());
        }
    }
    table.first_row.push_back(static_cast<std::uint32_t>(table.descendants.size()));
    return table;
}

} // namespace

/// Descendants of all states that are met, from the last cycle to the first.
class CompiledGrammar::Fusion {
public:
    explicit Fusion(const CompiledGrammar& grammar)
        : grammar_(grammar) {
        // Each is its own descendant after no cycle.
        for (std::uint32_t state = 0; state < grammar.rules_.size(); ++state)
            now_.push_back({{state}, {PairRow{0, {{1, 0}}}}});
    }

    [[nodiscard]] const std::vector<Descendants>& descendants() const { return now_; }

    /// One cycle more, in front of the others.
    void prepend(const std::vector<bool>& met) {
        assert(met.size() == now_.size());
        std::vector<Descendants> before(now_.size());
        for (std::size_t state = 0; state < now_.size(); ++state) {
            if (!met[state]) continue;
            for (std::size_t c = 0; c < grammar_.rules_[state].size(); ++c)
                append(now_[grammar_.rules_[state][c].state], grammar_.surroundings_[state][c], before[state]);
        }
        now_ = std::move(before);
    }

private:
    /// What a child becomes, over the parents round its cell.
    static void append(const Descendants& child, const Surroundings& around, Descendants& all) {
        std::vector<PairRow> rows;
        for (const CellRow& row : around.rows) rows.push_back(to_pairs(row));
        all.states.insert(all.states.end(), child.states.begin(), child.states.end());
        for (const PairRow& descendant : child.rows) {
            PairRow sum;
            const std::ptrdiff_t first = descendant.first - around.first;
            assert(descendant.weights.empty() ||
                   (first >= 0 && static_cast<std::size_t>(first) + descendant.weights.size() <= rows.size()));
            for (std::size_t k = 0; k < descendant.weights.size(); ++k)
                add(sum, descendant.weights[k], rows[static_cast<std::size_t>(first) + k]);
            all.rows.push_back(without_zeros(std::move(sum)));
        }
    }

    const CompiledGrammar& grammar_;
    std::vector<Descendants> now_;
};

std::optional<FusedStencils> CompiledGrammar::fuse(int cycles, const std::vector<bool>& wanted) const {
    if (cycles < 1) throw std::invalid_argument("stencils of fewer than one step");
    if (wanted.size() != automaton_->state_count()) throw std::invalid_argument("a wish for every state");
    if (cycles == 1) return one_cycle(*automaton_, wanted);
    std::vector<std::vector<bool>> met{wanted}; // states after 0, 1, … cycles
    for (int cycle = 1; cycle < cycles; ++cycle) met.push_back(children_of(met.back(), rules_));
    Fusion fusion(*this);
    for (std::size_t cycle = met.size(); cycle-- > 0;) fusion.prepend(met[cycle]);
    return table_of(fusion.descendants(), cycles);
}

RefinementPlan CompiledGrammar::plan(int cycles, const PlanOptions& options) const {
    PlanOptions chosen = options;
    if (fused_width_ > max_row_width) chosen.most_fused_steps = 1;
    const auto table = [this](int count, const std::vector<bool>& wanted) { return fuse(count, wanted); };
    return {automaton_, cells_, cycles, StepFuser{table, fused_width_}, chosen};
}

ModuleWord CompiledGrammar::word(std::span<const std::uint32_t> states, std::span<const double> points,
                                 std::size_t dimension) const {
    assert(points.size() == states.size() * dimension);
    ModuleWord word;
    std::vector<double> values;
    std::size_t cell = 0;
    while (cell < states.size()) {
        std::size_t next = cell;
        for (const std::uint32_t kind : emissions_[states[cell]].kinds) {
            values.clear();
            auto number = kinds_[kind].numbers.begin();
            for (const bool is_point : is_point_[kind]) {
                if (!is_point) {
                    values.push_back(to_double(*number++));
                    continue;
                }
                const auto from = points.subspan(next++ * dimension, dimension);
                values.insert(values.end(), from.begin(), from.end());
            }
            word.push_back(kinds_[kind].letter, values);
        }
        cell = std::max(next, cell + 1);
    }
    return word;
}

CompiledGrammar::WordSize CompiledGrammar::size(std::uint64_t cycles) const {
    constexpr std::uint64_t most = std::uint64_t{1} << 62;
    const auto plus = [](std::uint64_t& sum, std::uint64_t count, std::uint64_t each) {
        sum = each != 0 && count > (most - sum) / each ? most : sum + count * each;
    };
    std::vector<std::uint64_t> counts(rules_.size());
    for (const std::uint32_t state : cells_) ++counts[state];
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) {
        std::vector<std::uint64_t> next(counts.size());
        for (std::size_t state = 0; state < counts.size(); ++state)
            for (const CellChild& child : rules_[state]) plus(next[child.state], counts[state], 1);
        counts = std::move(next);
    }
    WordSize size;
    for (std::size_t state = 0; state < counts.size(); ++state) {
        plus(size.points, counts[state], 1);
        plus(size.modules, counts[state], emissions_[state].kinds.size());
        for (const std::uint32_t kind : emissions_[state].kinds)
            plus(size.numbers, counts[state], kinds_[kind].numbers.size());
    }
    return size;
}

std::optional<ModuleWord> CompiledGrammar::derive(std::span<const double> points, std::size_t dimension, int cycles,
                                                  const ApplyOptions& options) const {
    const RefinementPlan refinement = plan(cycles);
    if (refinement.output_size() == 0) return std::nullopt;
    std::vector<double> refined = in_large_pages<double>(refinement.output_size() * dimension);
    refinement.apply<double>(points, dimension, refined, options);
    return word(refinement.final_cells(), refined, dimension);
}

std::vector<double> cell_points(const ModuleWord& word, const PointSystem& system) {
    std::vector<double> points;
    for (std::size_t i = 0; i < word.size(); ++i) {
        std::span<const double> values = word.values(i);
        for (const Extent extent : system.layout()[to_index(word.letter(i))].value()) {
            const std::size_t width = std::max<std::size_t>(extent, 1);
            if (extent > 0)
                points.insert(points.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width));
            values = values.subspan(width);
        }
    }
    return points;
}

} // namespace internode
