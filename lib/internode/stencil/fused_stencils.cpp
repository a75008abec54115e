// SPDX-License-Identifier: MIT
//
// The rows of k steps at once are blossoms of the same old interval at the knots after k steps. They are taken in pairs
// of doubles from exact lengths and rounded once, two rows side by side. Where intermediate sums are so large that 106
// bits might not do, there is no table, and the plan goes step by step; the rows of one step are then exact.

#include "internode/stencil/fused_stencils.h"

#include "internode/algebra/double_double.h"
#include "internode/spline/window.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>

namespace internode {
namespace {

constexpr std::size_t max_width = 13; // degree 12

/// Two rows side by side: what every processor of the machines here has, and no larger, so that the bytes are the same.
typedef double TwoLanes __attribute__((vector_size(16))); // NOLINT(modernize-use-using): no attribute there

/// Intermediate combinations larger than this lose the bits that make the rounded rows right.
constexpr double largest_sum = 0x1p40;
/// A weight below this cannot be seen in a sum of d+1 products; it is what is left of an exact 0.
constexpr double smallest_weight = 0x1p-80;

template<typename Real>
constexpr std::size_t lane_count = sizeof(Real) / sizeof(double);

template<typename Real>
std::array<double, lane_count<Real>> lanes_of(Real lanes) {
    return std::bit_cast<std::array<double, lane_count<Real>>>(lanes);
}

/// The same number in every lane.
template<typename Real>
PairOf<Real> spread(DoubleDouble value) {
    if constexpr (lane_count<Real> == 1)
        return value;
    else
        return {Real{value.hi, value.hi}, Real{value.lo, value.lo}};
}

/// Numbers in a row, read by lanes.
class Arguments {
public:
    explicit Arguments(const std::vector<DoubleDouble>& values) {
        for (const DoubleDouble& value : values) {
            hi_.push_back(value.hi);
            lo_.push_back(value.lo);
        }
    }

    /// Numbers i, i + 1, …, one a lane.
    template<typename Real>
    [[nodiscard]] PairOf<Real> at(std::size_t i) const {
        assert(i + lane_count<Real> <= hi_.size());
        PairOf<Real> result;
        std::memcpy(&result.hi, &hi_[i], sizeof(Real));
        std::memcpy(&result.lo, &lo_[i], sizeof(Real));
        return result;
    }

private:
    std::vector<double> hi_;
    std::vector<double> lo_;
};

/// The blossom over one window in pairs of doubles; as spline/blossom.h has it in K.
class Piece {
public:
    explicit Piece(std::vector<DoubleDouble> local_knots)
        : knots_(std::move(local_knots)) {
        const std::size_t d = degree();
        assert(knots_.size() % 2 == 0 && d >= 1 && d < max_width && (knots_[d] - knots_[d - 1]).hi > 0);
        for (std::size_t level = 1; level <= d; ++level)
            for (std::size_t i = 0; i + level <= d; ++i)
                reciprocals_.push_back(DoubleDouble{1, 0} / (knots_[i + d] - knots_[i + level - 1]));
    }

    [[nodiscard]] std::size_t degree() const { return knots_.size() / 2; }
    [[nodiscard]] double largest() const { return largest_; }

    /// The d+1 weights at arguments `first` … `first` + d-1, and in the next lanes at those one further on.
    template<typename Real>
    std::array<PairOf<Real>, max_width> weights(const Arguments& arguments, std::size_t first) {
        const std::size_t d = degree();
        const PairOf<Real> one = spread<Real>({1, 0});
        std::array<PairOf<Real>, max_width> row{};
        row[0] = one;
        for (std::size_t level = d; level >= 1; --level) {
            const DoubleDouble* const reciprocals = reciprocals_of(level);
            const auto x = arguments.at<Real>(first + level - 1);
            // In place, from the right: entry i gives to i and i + 1.
            for (std::size_t i = d - level + 1; i-- > 0;) {
                const PairOf<Real> share = (x - spread<Real>(knots_[i + level - 1])) * spread<Real>(reciprocals[i]);
                const PairOf<Real> given = row[i] * share;
                row[i + 1] = row[i + 1] + given;
                row[i] = row[i] - given;
            }
            measure<Real>(std::span(row).first(d + 1));
        }
        return row;
    }

private:
    [[nodiscard]] const DoubleDouble* reciprocals_of(std::size_t level) const {
        assert(level >= 1 && level <= degree());
        // Level l has d - l + 1 of them.
        const std::size_t d = degree();
        return reciprocals_.data() + (level - 1) * (d + 1) - (level - 1) * level / 2;
    }

    template<typename Real>
    void measure(std::span<const PairOf<Real>> row) {
        Real sums{};
        for (const PairOf<Real>& entry : row) sums += entry.hi < 0 ? -entry.hi : entry.hi;
        for (const double sum : lanes_of(sums))
            if (!(sum <= largest_)) largest_ = sum;
    }

    std::vector<DoubleDouble> knots_;
    std::vector<DoubleDouble> reciprocals_;
    double largest_ = 0;
};

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
        Piece piece(local_knots(automaton_.state(state).window));
        const Arguments knots(refined_knots(table, state));
        const std::size_t rows = table.rows(state);
        std::size_t row = 0;
        for (; row + lane_count<TwoLanes> <= rows; row += lane_count<TwoLanes>)
            add(piece.weights<TwoLanes>(knots, row), table);
        for (; row < rows; ++row) add(piece.weights<double>(knots, row), table);
        if (piece.largest() <= largest_sum) return true;
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

    template<typename Real>
    static void add(const std::array<PairOf<Real>, max_width>& rows, FusedStencils& table) {
        for (std::size_t lane = 0; lane < lane_count<Real>; ++lane)
            for (std::size_t i = 0; i < table.width; ++i) {
                const double weight = lanes_of(rows[i].hi)[lane];
                table.weights.push_back(std::abs(weight) < smallest_weight ? 0 : weight);
            }
    }

    const StencilAutomaton& automaton_;
    std::vector<DoubleDouble> lengths_;
    std::vector<DoubleDouble> refined_lengths_; ///< after the steps
};

/// The states after one step more, state by state.
void add_generation(const StencilAutomaton& automaton, FusedStencils& table) {
    std::vector<std::uint32_t> first_row{0};
    std::vector<std::uint32_t> descendants;
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
