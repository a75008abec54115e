// SPDX-License-Identifier: MIT
//
// Dynamic programming over the columns of P: every candidate row goes on from the best choice of the column before that
// ends in an earlier row. Rows ascend, so two columns take one sweep. A closed curve is turned until column 0 keeps its
// heaviest row, and is read from there.

#include "internode/curve/reverse/kept_points.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

struct Candidate {
    std::size_t row = 0;
    double weight = 0;
    double cost = 0;      ///< cost of the best choice up to this column that ends here
    std::size_t back = 0; ///< the candidate of the column before
};

/// The columns of P: their weights by row, each row once.
class Columns {
public:
    explicit Columns(const GatherMatrix& matrix)
        : start_(matrix.columns + 1) {
        for_entries(matrix, [this](std::size_t, std::size_t column, double) { ++start_[column + 1]; });
        for (std::size_t k = 0; k < matrix.columns; ++k) start_[k + 1] += start_[k];
        candidates_.resize(start_.back());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        for_entries(matrix, [&](std::size_t row, std::size_t column, double weight) {
            candidates_[next[column]++] = {row, weight, 0, 0};
        });
    }

    [[nodiscard]] std::span<Candidate> of(std::size_t column) {
        return {candidates_.data() + start_[column], start_[column + 1] - start_[column]};
    }

private:
    template<typename Visit>
    static void for_entries(const GatherMatrix& matrix, Visit visit) {
        for (std::size_t l = 0; l < matrix.rows.size(); ++l) {
            const GatherRow& row = matrix.rows[l];
            // In a word shorter than the row the parents repeat with the period of the word.
            const std::size_t distinct = std::min(row.weights.size(), matrix.columns);
            for (std::size_t i = 0; i < distinct; ++i) {
                double weight = 0;
                for (std::size_t j = i; j < row.weights.size(); j += matrix.columns) weight += row.weights[j];
                if (weight > 0) visit(l, matrix.column(row.first + static_cast<std::ptrdiff_t>(i)), weight);
            }
        }
    }

    std::vector<std::size_t> start_;
    std::vector<Candidate> candidates_;
};

/// Rows counted from `origin`, going round.
void turn(std::span<Candidate> column, std::size_t origin, std::size_t rows) {
    assert(origin < rows);
    for (Candidate& candidate : column) candidate.row = (candidate.row + rows - origin) % rows;
    std::ranges::sort(column, {}, &Candidate::row);
}

/// The best continuation of each candidate from those of the column before that lie left of it.
void extend(std::span<const Candidate> before, std::span<Candidate> column) {
    constexpr double tie = 1e-9; // of costs that are sums of numbers >= 1: equal choices are made alike everywhere
    double best = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    std::size_t next = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Candidate& candidate : column) {
        for (; next < before.size() && before[next].row < candidate.row; ++next)
            if (before[next].cost < best - tie) {
                best = before[next].cost;
                chosen = next;
            }
        candidate.cost = best + 1 / candidate.weight;
        candidate.back = chosen;
        least = std::min(least, candidate.cost);
    }
    // Only differences count: without the common part the sums of long curves keep their digits.
    if (least < std::numeric_limits<double>::infinity())
        for (Candidate& candidate : column) candidate.cost -= least;
}

} // namespace

std::vector<std::size_t> kept_points(const GatherMatrix& matrix) {
    Columns columns(matrix);
    const std::size_t n = matrix.columns;
    const std::size_t rows = matrix.rows.size();
    assert(n >= 1);
    std::size_t origin = 0;
    if (matrix.ends == Ends::Circular) {
        const std::span<Candidate> first = columns.of(0);
        if (first.empty()) throw std::invalid_argument("a control point that nothing depends on");
        origin = std::ranges::max_element(first, {}, &Candidate::weight)->row;
        for (std::size_t k = 0; k < n; ++k) turn(columns.of(k), origin, rows);
    }
    // On a closed curve column 0 keeps its heaviest row, which is row 0 after turning.
    for (Candidate& candidate : columns.of(0)) {
        const bool free = matrix.ends == Ends::Open || candidate.row == 0;
        candidate.cost = free ? 1 / candidate.weight : std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 1; k < n; ++k) extend(columns.of(k - 1), columns.of(k));
    std::vector<std::size_t> kept(n);
    const std::span<Candidate> last = columns.of(n - 1);
    auto best = std::ranges::min_element(last, {}, &Candidate::cost);
    if (best == last.end() || !(best->cost < std::numeric_limits<double>::infinity()))
        throw std::invalid_argument("the rows of the step do not separate its control points");
    auto place = static_cast<std::size_t>(best - last.begin());
    for (std::size_t k = n; k-- > 0;) {
        assert(place < columns.of(k).size());
        const Candidate& candidate = columns.of(k)[place];
        kept[k] = (candidate.row + origin) % rows;
        place = candidate.back;
    }
    return kept;
}

} // namespace internode
