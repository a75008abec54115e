// SPDX-License-Identifier: MIT
//
// The rows of k steps at once are blossoms of the same old interval at the knots after k steps. They are taken in pairs
// of doubles from exact lengths and rounded once, two rows side by side. Where intermediate sums are so large that 106
// bits might not do, there is no table, and the plan goes step by step; the rows of one step are then exact.

#include "internode/stencil/fused_stencils.h"

#include "internode/algebra/double_double.h"
#include "internode/spline/window.h"
#include "internode/stencil/blossom_rows.h"
#include "internode/stencil/kernel.h"

#include <cassert>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

/// Intermediate combinations larger than this lose the bits that make the rounded rows right.
constexpr double largest_sum = 0x1p40;

/// Of a window's 2d knots.
BlossomPiece piece_of(const std::vector<DoubleDouble>& knots) {
    const std::size_t d = knots.size() / 2;
    assert(knots.size() % 2 == 0 && d >= 1 && d < max_row_width && (knots[d] - knots[d - 1]).hi > 0);
    BlossomPiece piece{d, {}, {}};
    piece.knots.reserve(2 * d);
    piece.reciprocals.reserve(d * (d + 1) / 2);
    for (const DoubleDouble& knot : knots) piece.knots.push_back(knot);
    for (std::size_t level = 1; level <= d; ++level)
        for (std::size_t i = 0; i + level <= d; ++i)
            piece.reciprocals.push_back(DoubleDouble{1, 0} / (knots[i + d] - knots[i + level - 1]));
    return piece;
}

class Fusion {
public:
    Fusion(const StencilAutomaton& automaton, const IntervalSystem& system, int steps)
        : automaton_(automaton) {
        for (const Number& length : system.lengths()) lengths_.push_back(to_double_double(length));
        DoubleDouble scale{1, 0};
        const DoubleDouble ratio = to_double_double(system.ratio());
        for (int step = 0; step < steps; ++step) scale = scale / ratio;
        for (const DoubleDouble& length : lengths_) refined_lengths_.push_back(length * scale);
    }

    /// Adds the rows of a state that has some; false, and none are added, when they would not be precise.
    bool add_rows(std::uint32_t state, FusedStencils& table) const {
        const std::size_t before = table.weights.size();
        assert(table.rows(state) > 0 && before == table.first_row[state] * table.width);
        const BlossomPiece piece = piece_of(local_knots(automaton_.state(state).window));
        const std::size_t rows = table.rows(state);
        PairArray arguments;
        arguments.reserve(rows + piece.degree - 1 + blossom_padding);
        for (const DoubleDouble& knot : refined_knots(table, state)) arguments.push_back(knot);
        for (std::size_t i = 0; i < blossom_padding; ++i) arguments.push_back({});
        table.weights.resize(before + rows * table.width);
        if (blossom_rows(piece, arguments, rows, table.weights.data() + before) <= largest_sum) return true;
        table.weights.resize(before);
        return false;
    }

private:
    [[nodiscard]] DoubleDouble length(Symbol symbol, const std::vector<DoubleDouble>& lengths) const {
        return symbol == zero_interval ? DoubleDouble{} : lengths[to_index(symbol)];
    }

    /// The 2d knots of a window, 0 where its middle interval starts.
    [[nodiscard]] std::vector<DoubleDouble> local_knots(const Word& window) const {
        assert(window.size() % 2 == 1);
        const std::size_t d = window.size() / 2 + 1;
        std::vector<DoubleDouble> knots(2 * d);
        for (std::size_t i = d; i < 2 * d; ++i) knots[i] = knots[i - 1] + length(window[i - 1], lengths_);
        for (std::size_t i = d - 1; i-- > 0;) knots[i] = knots[i + 1] - length(window[i], lengths_);
        return knots;
    }

    /// The knots after the start of each descendant's cell, d of them from entry `row` on for that row.
    [[nodiscard]] std::vector<DoubleDouble> refined_knots(const FusedStencils& table, std::uint32_t state) const {
        assert(table.rows(state) > 0);
        const std::size_t d = table.width - 1;
        const CellState& cell = automaton_.state(state);
        const std::uint32_t first = table.first_row[state];
        const std::uint32_t last = table.first_row[state + 1] - 1;
        if (cell.lead > 0) return leading_knots(automaton_.state(table.descendants[first]).window, d, cell.lead);
        std::vector<DoubleDouble> knots;
        knots.reserve(table.rows(state) + d - 1);
        DoubleDouble at;
        for (std::uint32_t row = first; row <= last; ++row) {
            const Word& window = automaton_.state(table.descendants[row]).window;
            at = at + length(window[d - 1], refined_lengths_);
            knots.push_back(at);
        }
        // Children fill the interval: ρ a = M a.
        knots.back() = at = length(cell.window[d - 1], lengths_);
        const Word& end = automaton_.state(table.descendants[last]).window;
        for (std::size_t i = d; i < 2 * d - 1; ++i) knots.push_back(at = at + length(end[i], refined_lengths_));
        return knots;
    }

    /// u_{1-z} … u_{d-z} around child 0, which starts at u_0 = 0.
    [[nodiscard]] std::vector<DoubleDouble> leading_knots(const Word& window, std::size_t d, std::size_t lead) const {
        assert(lead >= 1 && lead <= d && window.size() == 2 * d - 1);
        std::vector<DoubleDouble> knots(2 * d);
        for (std::size_t i = d; i < 2 * d; ++i) knots[i] = knots[i - 1] + length(window[i - 1], refined_lengths_);
        for (std::size_t i = d - 1; i-- > 0;) knots[i] = knots[i + 1] - length(window[i], refined_lengths_);
        const auto first = knots.begin() + static_cast<std::ptrdiff_t>(d - lead);
        return {first, first + static_cast<std::ptrdiff_t>(d)};
    }

    const StencilAutomaton& automaton_;
    std::vector<DoubleDouble> lengths_;
    std::vector<DoubleDouble> refined_lengths_; ///< after the steps
};

/// The states after one step more, state by state.
void add_generation(const StencilAutomaton& automaton, FusedStencils& table) {
    std::vector<std::uint32_t> first_row{0};
    std::vector<std::uint32_t> descendants;
    first_row.reserve(automaton.state_count() + 1);
    descendants.reserve(2 * table.descendants.size());
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        for (const StencilAutomaton::Child& child : automaton.children(state))
            descendants.insert(descendants.end(), table.descendants.begin() + table.first_row[child.state],
                               table.descendants.begin() + table.first_row[child.state + 1]);
        if (descendants.size() > std::numeric_limits<std::uint32_t>::max())
            throw std::length_error("a table of stencils with more than 2^32 - 1 rows");
        first_row.push_back(static_cast<std::uint32_t>(descendants.size()));
    }
    table.first_row = std::move(first_row);
    table.descendants = std::move(descendants);
}

/// What is not wanted has no row.
void keep(const std::vector<bool>& wanted, FusedStencils& table) {
    assert(table.first_row.size() == wanted.size() + 1);
    std::vector<std::uint32_t> descendants;
    std::vector<std::uint32_t> first_row{0};
    for (std::uint32_t state = 0; state < wanted.size(); ++state) {
        if (wanted[state])
            descendants.insert(descendants.end(), table.descendants.begin() + table.first_row[state],
                               table.descendants.begin() + table.first_row[state + 1]);
        first_row.push_back(static_cast<std::uint32_t>(descendants.size()));
    }
    table.first_row = std::move(first_row);
    table.descendants = std::move(descendants);
}

/// The exact rows of one step of a state, rounded; derived here when the automaton was made without.
void add_exact_rows(const StencilAutomaton& automaton, const IntervalSystem& system, std::uint32_t state,
                    FusedStencils& table) {
    const auto add = [&table](const std::vector<Number>& row) {
        for (const Number& weight : row) table.weights.push_back(weight.to_double());
    };
    if (automaton.row_count() > 0) {
        for (const StencilAutomaton::Child& child : automaton.children(state)) {
            const auto row = automaton.weights(child.row);
            table.weights.insert(table.weights.end(), row.begin(), row.end());
        }
        return;
    }
    const CellState& cell = automaton.state(state);
    const WindowPiece piece(system, cell.window);
    if (cell.lead > 0)
        add(piece.leading(cell.lead));
    else
        for (std::size_t c = 0; c < piece.child_count(); ++c) add(piece.child(c));
}

/// No step yet: every state is its own descendant.
FusedStencils generation_zero(const StencilAutomaton& automaton, int steps) {
    FusedStencils table;
    table.steps = steps;
    table.width = automaton.width();
    table.first_row.resize(automaton.state_count() + 1);
    std::iota(table.first_row.begin(), table.first_row.end(), 0U);
    table.descendants.resize(automaton.state_count());
    std::iota(table.descendants.begin(), table.descendants.end(), 0U);
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state)
        table.offset.push_back(static_cast<std::int32_t>(automaton.offset(state)));
    return table;
}

} // namespace

std::optional<FusedStencils> fuse(const StencilAutomaton& automaton, const IntervalSystem& system, int steps,
                                  const std::vector<bool>& wanted) {
    if (steps < 1) throw std::invalid_argument("stencils of fewer than one step");
    if (wanted.size() != automaton.state_count()) throw std::invalid_argument("a wish for every state");
    FusedStencils table = generation_zero(automaton, steps);
    for (int step = 0; step < steps; ++step) add_generation(automaton, table);
    keep(wanted, table);
    table.weights.reserve(table.row_count() * table.width);
    std::optional<Fusion> fusion;
    if (steps > 1 || automaton.row_count() == 0) fusion.emplace(automaton, system, steps);
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        if (table.rows(state) == 0 || (fusion && fusion->add_rows(state, table))) continue;
        if (steps > 1) return std::nullopt;
        add_exact_rows(automaton, system, state, table);
    }
    assert(table.weights.size() == table.row_count() * table.width);
    return table;
}

} // namespace internode
