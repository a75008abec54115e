// SPDX-License-Identifier: MIT

#include "internode/surface/refinement.h"

#include "internode/curve/gather.h"
#include "internode/curve/refinement.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > most / b ? most : a * b;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return a > most - b ? most : a + b;
}

/// Points of `dimension` coordinates over the knots, one step finer.
class Pass {
public:
    Pass(const Knots& knots, std::size_t dimension)
        : dimension_(dimension)
        , cells_(cell_states(knots.word(), knots.degree(), knots.ends()))
        , automaton_(make_automaton(knots.system(), knots.degree(), cells_, max_states)) {
        for (const CellState& cell : cells_) states_.push_back(automaton_.find(cell));
    }

    std::vector<double> step(const std::vector<double>& points) {
        std::vector<double> fine;
        std::vector<std::uint32_t> states;
        Parents parents(points, dimension_, automaton_.width());
        for (std::size_t cell = 0; cell < states_.size(); ++cell) {
            const double* rows = parents.rows(static_cast<std::ptrdiff_t>(cell) + automaton_.offset(states_[cell]));
            for (const StencilAutomaton::Child& child : automaton_.children(states_[cell])) {
                states.push_back(child.state);
                fine.resize(states.size() * dimension_);
                combine(automaton_.weights(child.row), rows, dimension_, &fine[fine.size() - dimension_]);
            }
        }
        states_ = std::move(states);
        return fine;
    }

private:
    std::size_t dimension_;
    std::vector<CellState> cells_;
    StencilAutomaton automaton_;
    std::vector<std::uint32_t> states_;
};

std::vector<double> refined(const Knots& knots, std::size_t dimension, std::vector<double> points, int steps) {
    if (steps == 0) return points;
    Pass pass(knots, dimension);
    for (int step = 0; step < steps; ++step) points = pass.step(points);
    return points;
}

/// Rows of columns of entries, as columns of rows.
std::vector<double> transposed(const std::vector<double>& points, std::size_t rows, std::size_t columns,
                               std::size_t dimension) {
    std::vector<double> result(points.size());
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            std::copy_n(&points[(i * columns + j) * dimension], dimension, &result[(j * rows + i) * dimension]);
    return result;
}

} // namespace

GridSize refined_size(const Grid& grid, std::uint64_t steps_u, std::uint64_t steps_v, std::uint64_t cap) {
    const RefinementSize u = refined_size(grid.u(), 1, steps_u, cap);
    const RefinementSize v = refined_size(grid.v(), 1, steps_v, cap);
    GridSize size;
    size.rows = u.points;
    size.columns = v.points;
    size.points = product(size.rows, size.columns);
    size.exceeded = u.exceeded || v.exceeded || size.points > cap;
    const std::uint64_t between = product(grid.u().size(), size.columns);
    const std::uint64_t all = sum(sum(grid.size(), between), size.points);
    size.bytes = product(all, grid.dimension() * sizeof(double));
    return size;
}

Grid refine(const Grid& grid, int steps_u, int steps_v) {
    if (steps_u < 0 || steps_v < 0) throw std::invalid_argument("a negative number of steps");
    const std::size_t dimension = grid.dimension();
    const std::size_t rows = grid.u().size();
    const Knots u = refined_knots(grid.u(), steps_u);
    const Knots v = refined_knots(grid.v(), steps_v);
    std::vector<double> points = transposed(grid.points(), rows, grid.v().size(), dimension);
    points = refined(grid.v(), rows * dimension, std::move(points), steps_v);
    points = transposed(points, v.size(), rows, dimension);
    points = refined(grid.u(), v.size() * dimension, std::move(points), steps_u);
    return Grid({u, v, dimension, grid.rational(), std::move(points)});
}

} // namespace internode
