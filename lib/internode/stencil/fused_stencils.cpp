// SPDX-License-Identifier: MIT
//
// The rows of k steps at once are blossoms of the same old interval at the knots after k steps. They are taken in pairs
// of doubles from exact lengths and rounded once, several rows side by side. Where intermediate sums are so large that
// 106 bits might not do, there is no table, and the plan goes step by step; the rows of one step are then exact.

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

} // namespace

struct IntervalFuser::Lengths {
    std::vector<DoubleDouble> of_symbol;
    DoubleDouble ratio;
};

/// Fills a table for one number of steps; what it needs for a state is kept for the next one.
class IntervalFuser::Rows {
public:
    Rows(const StencilAutomaton& automaton, const Lengths& lengths, FusedStencils& table)
        : automaton_(automaton)
        , lengths_(lengths)
        , table_(table)
        , degree_(table.width - 1) {
        DoubleDouble scale{1, 0};
        for (int step = 0; step < table.steps; ++step) scale = scale / lengths.ratio;
        for (const DoubleDouble& length : lengths.of_symbol) refined_lengths_.push_back(length * scale);
        within_.resize(lengths.of_symbol.size());
    }

    /// Adds the rows of a state that has some; false, and none are added, when they would not be precise.
    bool add(std::uint32_t state) {
        const std::size_t before = table_.weights.size();
        const std::size_t rows = table_.rows(state);
        assert(rows > 0 && before == table_.first_row[state] * table_.width);
        set_piece(automaton_.state(state).window);
        set_arguments(state);
        assert(arguments_.hi.size() == rows + degree_ - 1 + blossom_padding);
        table_.weights.resize(before + rows * table_.width);
        if (blossom_rows(piece_, arguments_, rows, table_.weights.data() + before) <= largest_sum) return true;
        table_.weights.resize(before);
        return false;
    }

private:
    [[nodiscard]] static DoubleDouble length(Symbol symbol, const std::vector<DoubleDouble>& lengths) {
        return symbol == zero_interval ? DoubleDouble{} : lengths[to_index(symbol)];
    }

    /// The 2d knots of a window, 0 where its middle interval starts.
    void set_knots(const Word& window, const std::vector<DoubleDouble>& lengths) {
        const std::size_t d = degree_;
        assert(window.size() == 2 * d - 1);
        knots_.resize(2 * d);
        knots_[d - 1] = {};
        for (std::size_t i = d; i < 2 * d; ++i) knots_[i] = knots_[i - 1] + length(window[i - 1], lengths);
        for (std::size_t i = d - 1; i-- > 0;) knots_[i] = knots_[i + 1] - length(window[i], lengths);
    }

    void set_piece(const Word& window) {
        const std::size_t d = degree_;
        set_knots(window, lengths_.of_symbol);
        assert((knots_[d] - knots_[d - 1]).hi > 0);
        piece_.degree = d;
        piece_.knots.clear();
        for (const DoubleDouble& knot : knots_) piece_.knots.push_back(knot);
    }

    /// The knots after the start of each descendant's cell, d of them from entry r on for the state's row r.
    void set_arguments(std::uint32_t state) {
        const std::size_t d = degree_;
        const CellState& cell = automaton_.state(state);
        arguments_.clear();
        const Word& end = automaton_.state(table_.descendants[table_.first_row[state + 1] - 1]).window;
        if (cell.lead > 0) {
            // u_{1-z} … u_{d-z} around child 0, which starts at u_0 = 0.
            set_knots(end, refined_lengths_);
            for (std::size_t i = 0; i < d; ++i) arguments_.push_back(knots_[d - cell.lead + i]);
        } else {
            const PairArray& within = within_middle(state);
            arguments_.hi = within.hi;
            arguments_.lo = within.lo;
            // Children fill the interval: ρ a = M a.
            DoubleDouble at = length(cell.window[d - 1], lengths_.of_symbol);
            arguments_.push_back(at);
            for (std::size_t i = d; i < 2 * d - 1; ++i)
                arguments_.push_back(at = at + length(end[i], refined_lengths_));
        }
        for (std::size_t i = 0; i < blossom_padding; ++i) arguments_.push_back({});
    }

    /// The knots within the middle interval of a state without lead: they are the same for all windows around it.
    const PairArray& within_middle(std::uint32_t state) {
        PairArray& known = within_[to_index(automaton_.state(state).window[degree_ - 1])];
        if (!known.hi.empty() || table_.rows(state) == 1) return known;
        DoubleDouble at;
        for (std::uint32_t row = table_.first_row[state]; row + 1 < table_.first_row[state + 1]; ++row) {
            at = at + length(automaton_.state(table_.descendants[row]).window[degree_ - 1], refined_lengths_);
            known.push_back(at);
        }
        return known;
    }

    const StencilAutomaton& automaton_;
    const Lengths& lengths_;
    FusedStencils& table_;
    std::size_t degree_;
    std::vector<DoubleDouble> refined_lengths_; ///< after the steps
    std::vector<PairArray> within_;             ///< of each symbol whose interval has been asked for
    std::vector<DoubleDouble> knots_;
    BlossomPiece piece_{};
    PairArray arguments_;
};

namespace {

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

IntervalFuser::IntervalFuser(std::shared_ptr<const StencilAutomaton> automaton, const IntervalSystem& system)
    : automaton_(std::move(automaton))
    , system_(system) {}

std::optional<FusedStencils> IntervalFuser::table(int steps, const std::vector<bool>& wanted) {
    if (steps < 1) throw std::invalid_argument("stencils of fewer than one step");
    if (wanted.size() != automaton_->state_count()) throw std::invalid_argument("a wish for every state");
    FusedStencils table = generation_zero(*automaton_, steps);
    for (int step = 0; step < steps; ++step) add_generation(*automaton_, table);
    keep(wanted, table);
    table.weights.reserve(table.row_count() * table.width);
    std::optional<Rows> rows;
    if (steps > 1 || automaton_->row_count() == 0) rows.emplace(*automaton_, lengths(), table);
    for (std::uint32_t state = 0; state < automaton_->state_count(); ++state) {
        if (table.rows(state) == 0 || (rows && rows->add(state))) continue;
        if (steps > 1) return std::nullopt;
        add_exact_rows(*automaton_, system_, state, table);
    }
    assert(table.weights.size() == table.row_count() * table.width);
    return table;
}

const IntervalFuser::Lengths& IntervalFuser::lengths() {
    if (lengths_ == nullptr) {
        Lengths made;
        for (const Number& length : system_.lengths()) made.of_symbol.push_back(to_double_double(length));
        made.ratio = to_double_double(system_.ratio());
        lengths_ = std::make_shared<const Lengths>(std::move(made));
    }
    return *lengths_;
}

} // namespace internode
