// SPDX-License-Identifier: MIT

#include "internode/stencil/step_matrix.h"

#include "internode/stencil/automaton.h"

#include <cassert>
#include <limits>
#include <map>
#include <stdexcept>

namespace internode {
namespace {

/// cell + shift, wrapped into 0 … columns-1; only circular words ever wrap.
std::uint64_t wrapped(std::size_t cell, std::ptrdiff_t shift, std::uint64_t columns) {
    assert(columns > 0);
    const auto n = static_cast<std::ptrdiff_t>(columns);
    return static_cast<std::uint64_t>(((static_cast<std::ptrdiff_t>(cell) + shift) % n + n) % n);
}

void add_row(StepMatrix& matrix, std::span<const Number> weights, std::size_t cell, std::ptrdiff_t offset) {
    std::map<std::uint64_t, Number> row;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i].sign() != 0)
            row[wrapped(cell, offset + static_cast<std::ptrdiff_t>(i), matrix.columns)] += weights[i];
    for (auto& [column, weight] : row) matrix.entries.push_back({matrix.rows, column, std::move(weight)});
    ++matrix.rows;
}

} // namespace

StepMatrix step_matrix(const IntervalSystem& system, int degree, WordView word, Ends ends) {
    const std::vector<CellState> cells = cell_states(word, degree, ends);
    const StencilAutomaton automaton = make_automaton(system, degree, cells, max_states);
    StepMatrix matrix;
    matrix.columns = cells.size();
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const std::uint32_t state = automaton.find(cells[cell]);
        for (const StencilAutomaton::Child& child : automaton.children(state))
            add_row(matrix, automaton.exact_weights(child.row), cell, automaton.offset(state));
    }
    return matrix;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> sparse(const StepMatrix& matrix) {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    if (matrix.rows > most || matrix.columns > most || matrix.entries.size() > most)
        throw std::length_error("a sparse matrix with more than 2^31 - 1 rows, columns or entries");
    Eigen::SparseMatrix<double, Eigen::RowMajor> result(static_cast<int>(matrix.rows),
                                                        static_cast<int>(matrix.columns));
    result.reserve(static_cast<Eigen::Index>(matrix.entries.size()));
    std::uint64_t next_row = 0;
    for (const StepMatrix::Entry& entry : matrix.entries) {
        assert(entry.row < matrix.rows && entry.column < matrix.columns && entry.row + 1 >= next_row);
        while (next_row <= entry.row) result.startVec(static_cast<Eigen::Index>(next_row++));
        result.insertBack(static_cast<Eigen::Index>(entry.row), static_cast<Eigen::Index>(entry.column)) =
            entry.weight.to_double();
    }
    result.finalize();
    return result;
}

} // namespace internode
