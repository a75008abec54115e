// SPDX-License-Identifier: MIT
//
// A closed curve is an endless line of cells here (Line), so that no window wraps. Windows whose cells have the same
// states, with the coarse point at the same place, have the same filter, which is computed once.

#include "internode/curve/reverse/local_filters.h"

#include "internode/curve/reverse/normal_equations.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

namespace internode {

namespace {

/// Quotient towards minus infinity, for indices that go round a closed curve.
std::ptrdiff_t turns(std::ptrdiff_t index, std::size_t period) {
    assert(period > 0);
    const auto n = static_cast<std::ptrdiff_t>(period);
    return index >= 0 ? index / n : -((-index + n - 1) / n);
}

/// The cells of one level as an endless line where the curve is closed.
class Line {
public:
    Line(const Hierarchy& hierarchy, int level, const GatherMatrix& matrix)
        : matrix_(matrix)
        , states_(hierarchy.states(level))
        , degree_(hierarchy.coarse().degree()) {
        const StencilAutomaton& automaton = hierarchy.automaton();
        first_child_.push_back(0);
        for (std::size_t cell = 0; cell < states_.size(); ++cell) {
            if (automaton.state(states_[cell]).lead == 0) starts_.push_back(static_cast<std::ptrdiff_t>(cell));
            first_child_.push_back(first_child_.back() +
                                   static_cast<std::ptrdiff_t>(automaton.children(states_[cell]).size()));
        }
    }

    /// Cell of the i-th interval with a length; any i when closed.
    [[nodiscard]] std::ptrdiff_t start(std::ptrdiff_t i) const {
        const std::ptrdiff_t round = turns(i, starts_.size());
        const auto place = static_cast<std::size_t>(i - round * static_cast<std::ptrdiff_t>(starts_.size()));
        return starts_[place] + round * static_cast<std::ptrdiff_t>(states_.size());
    }
    [[nodiscard]] std::ptrdiff_t start_count() const { return static_cast<std::ptrdiff_t>(starts_.size()); }
    [[nodiscard]] std::ptrdiff_t first_child(std::ptrdiff_t cell) const {
        if (cell == static_cast<std::ptrdiff_t>(states_.size())) return first_child_.back();
        const std::ptrdiff_t round = turns(cell, states_.size());
        const auto place = static_cast<std::size_t>(cell - round * static_cast<std::ptrdiff_t>(states_.size()));
        return first_child_[place] + round * first_child_.back();
    }
    [[nodiscard]] std::uint32_t state(std::ptrdiff_t cell) const { return states_[matrix_.column(cell)]; }
    /// Row l of P, its parents counted along the line.
    [[nodiscard]] GatherRow row(std::ptrdiff_t l) const {
        const std::ptrdiff_t round = turns(l, matrix_.rows.size());
        const auto place = static_cast<std::size_t>(l - round * static_cast<std::ptrdiff_t>(matrix_.rows.size()));
        GatherRow row = matrix_.rows[place];
        row.first += round * static_cast<std::ptrdiff_t>(states_.size());
        return row;
    }
    /// The interval with a length in the support k … k+d that is nearest to its middle, as the i of start(i).
    [[nodiscard]] std::ptrdiff_t middle(std::size_t k) const {
        const auto left = static_cast<std::ptrdiff_t>(k);
        const bool closed = matrix_.ends == Ends::Circular;
        auto best = std::ranges::lower_bound(starts_, left) - starts_.begin();
        assert(closed || best < start_count());
        const auto distance = [&](std::ptrdiff_t i) { return std::abs(2 * start(i) - 2 * left - degree_); };
        for (std::ptrdiff_t i = best + 1; (closed || i < start_count()) && start(i) <= left + degree_; ++i)
            if (distance(i) < distance(best)) best = i;
        return best;
    }
    [[nodiscard]] std::ptrdiff_t degree() const { return degree_; }
    [[nodiscard]] bool closed() const { return matrix_.ends == Ends::Circular; }

private:
    const GatherMatrix& matrix_;
    const std::vector<std::uint32_t>& states_;
    std::ptrdiff_t degree_;
    std::vector<std::ptrdiff_t> starts_;      ///< cells of intervals with a length
    std::vector<std::ptrdiff_t> first_child_; ///< fine point of each cell, and behind the last
};

/// The old intervals begin … end - 1 around a coarse point.
struct Window {
    std::ptrdiff_t begin = 0;
    std::ptrdiff_t end = 0;
};

Window window_of(const Line& line, std::size_t k, std::size_t intervals) {
    auto m = static_cast<std::ptrdiff_t>(intervals);
    std::ptrdiff_t first = line.middle(k) - (m - 1) / 2;
    if (!line.closed()) {
        m = std::min(m, line.start_count());
        first = std::clamp<std::ptrdiff_t>(first, 0, line.start_count() - m);
    }
    return {line.start(first), line.start(first + m - 1) + 1};
}

/// P of the window: old points begin - d … end - 1, the fine points whose support meets it.
GatherMatrix restricted(const Line& line, Window window) {
    const std::ptrdiff_t first_column = window.begin - line.degree();
    GatherMatrix matrix;
    matrix.columns = static_cast<std::size_t>(window.end - first_column);
    for (std::ptrdiff_t l = line.first_child(window.begin) - line.degree(); l < line.first_child(window.end); ++l) {
        GatherRow row = line.row(l);
        row.first -= first_column;
        assert(row.first >= 0 && row.first + static_cast<std::ptrdiff_t>(row.weights.size()) <=
                                     static_cast<std::ptrdiff_t>(matrix.columns));
        matrix.rows.push_back(row);
    }
    return matrix;
}

/// Row `column` of (PᵀP)^{-1} Pᵀ, refined so that A P = I holds to rounding.
std::vector<double> pseudo_inverse_row(const GatherMatrix& matrix, std::size_t column) {
    assert(column < matrix.columns);
    constexpr int refinements = 2;
    const NormalEquations equations(matrix);
    std::vector<double> filter(matrix.rows.size());
    for (int pass = 0; pass <= refinements; ++pass) {
        std::vector<double> wanted = transposed_product(matrix, filter, 1);
        for (double& number : wanted) number = -number;
        wanted[column] += 1;
        equations.solve(wanted, 1);
        const std::vector<double> correction = product(matrix, wanted, 1);
        for (std::size_t i = 0; i < filter.size(); ++i) filter[i] += correction[i];
    }
    return filter;
}

} // namespace

LocalFilters::LocalFilters(const Hierarchy& hierarchy, int level, const GatherMatrix& matrix, std::size_t window)
    : fine_size_(matrix.rows.size()) {
    if (window < 1) throw std::invalid_argument("a window of no interval");
    const Line line(hierarchy, level, matrix);
    std::map<std::vector<std::uint32_t>, std::size_t> known; // by the states of the window's cells and the place in it
    for (std::size_t k = 0; k < matrix.columns; ++k) {
        const Window around = window_of(line, k, window);
        const std::ptrdiff_t first_column = around.begin - line.degree();
        const auto column = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) - first_column);
        std::vector<std::uint32_t> key{static_cast<std::uint32_t>(column)};
        for (std::ptrdiff_t cell = first_column; cell < around.end; ++cell) key.push_back(line.state(cell));
        const auto [entry, is_new] = known.try_emplace(std::move(key), filters_.size());
        if (is_new) filters_.push_back(pseudo_inverse_row(restricted(line, around), column));
        places_.push_back({line.first_child(around.begin) - line.degree(), entry->second});
    }
}

std::vector<double> LocalFilters::apply(std::span<const double> fine, std::size_t dimension) const {
    if (dimension == 0 || fine.size() != fine_size_ * dimension)
        throw std::invalid_argument("the points are not as many as the filters take");
    std::vector<double> coarse(places_.size() * dimension);
    double* out = coarse.data();
    for (const Place& place : places_) {
        std::ptrdiff_t l = place.first - turns(place.first, fine_size_) * static_cast<std::ptrdiff_t>(fine_size_);
        for (const double weight : filters_[place.filter]) {
            const double* const in = fine.data() + static_cast<std::size_t>(l) * dimension;
            for (std::size_t c = 0; c < dimension; ++c) out[c] += weight * in[c];
            if (++l == static_cast<std::ptrdiff_t>(fine_size_)) l = 0;
        }
        out += dimension;
    }
    return coarse;
}

} // namespace internode
