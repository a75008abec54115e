// SPDX-License-Identifier: MIT
//
// The details are taken of the residual r = f - P c instead of f. What P makes of coarse points is foretold by its kept
// points, so e is the same, and small numbers lose fewer digits. With x from P_K x = r_K they are e = r_D - P_D x: K
// the kept rows, D the others.

#include "internode/curve/reverse/reverse_step.h"

#include "internode/curve/reverse/kept_points.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace internode {

namespace {

/// 0 … size - 1 without the kept ones.
std::vector<std::size_t> others(const std::vector<std::size_t>& kept, std::size_t size) {
    assert(kept.size() <= size);
    std::vector<bool> is_kept(size);
    for (const std::size_t point : kept) is_kept[point] = true;
    std::vector<std::size_t> rest;
    rest.reserve(size - kept.size());
    for (std::size_t point = 0; point < size; ++point)
        if (!is_kept[point]) rest.push_back(point);
    return rest;
}

std::vector<double> chosen_rows(std::span<const double> rows, const std::vector<std::size_t>& places,
                                std::size_t dimension) {
    std::vector<double> chosen;
    chosen.reserve(places.size() * dimension);
    for (const std::size_t place : places) {
        const auto row = rows.subspan(place * dimension, dimension);
        chosen.insert(chosen.end(), row.begin(), row.end());
    }
    return chosen;
}

KeptRows kept_rows(const GatherMatrix& matrix, const std::vector<std::size_t>& kept) {
    GatherMatrix square;
    square.ends = matrix.ends;
    square.columns = matrix.columns;
    square.rows.reserve(kept.size());
    for (const std::size_t point : kept) square.rows.push_back(matrix.rows[point]);
    NormalEquations equations(square);
    return {std::move(square), std::move(equations)};
}

} // namespace

ReverseStep::ReverseStep(const Hierarchy& hierarchy, int level, const ReverseOptions& options)
    : matrix_(hierarchy.matrix(level))
    , identity_(matrix_.is_identity()) {
    if (identity_) return;
    kept_ = kept_points(matrix_);
    inserted_ = others(kept_, fine_size());
    if (options.method == ReverseMethod::Local)
        filters_.emplace(hierarchy, level, matrix_, options.window);
    else
        equations_.emplace(matrix_);
}

void ReverseStep::prepare_details() {
    if (!inserted_.empty() && !kept_rows_) kept_rows_ = kept_rows(matrix_, kept_);
}

std::vector<double> ReverseStep::coarse(std::span<const double> fine, std::size_t dimension) const {
    if (dimension == 0 || fine.size() != fine_size() * dimension)
        throw std::invalid_argument("the fine polygon has another number of points");
    if (identity_) return {fine.begin(), fine.end()};
    return filters_ ? filters_->apply(fine, dimension) : least_squares(matrix_, *equations_, fine, dimension);
}

Details ReverseStep::details(std::span<const double> fine, std::span<const double> coarse,
                             std::size_t dimension) const {
    if (dimension == 0 || fine.size() != fine_size() * dimension)
        throw std::invalid_argument("the fine polygon has another number of points");
    std::vector<double> residual = product(matrix_, coarse, dimension);
    for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = fine[i] - residual[i];
    Details details;
    if (inserted_.empty()) return details;
    const std::vector<double> at_kept = [&] {
        const std::vector<double> kept = chosen_rows(residual, kept_, dimension);
        if (kept_rows_) return least_squares(kept_rows_->matrix, kept_rows_->equations, kept, dimension);
        const KeptRows square = kept_rows(matrix_, kept_);
        return least_squares(square.matrix, square.equations, kept, dimension);
    }();
    const std::vector<double> foretold = product(matrix_, at_kept, dimension);
    for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= foretold[i];
    details.points = inserted_;
    details.vectors = chosen_rows(residual, inserted_, dimension);
    return details;
}

std::vector<double> ReverseStep::fine(std::span<const double> coarse, const Details& details,
                                      std::size_t dimension) const {
    if (details.vectors.size() != details.points.size() * dimension)
        throw std::invalid_argument("every detail has one vector");
    if (details.points.empty()) return product(matrix_, coarse, dimension);
    std::vector<double> filled(fine_size() * dimension);
    for (std::size_t i = 0; i < details.points.size(); ++i) {
        if (details.points[i] >= fine_size()) throw std::out_of_range("a detail at a point that is not there");
        std::copy_n(details.vectors.begin() + static_cast<std::ptrdiff_t>(i * dimension), dimension,
                    filled.begin() + static_cast<std::ptrdiff_t>(details.points[i] * dimension));
    }
    std::vector<double> shifted = this->coarse(filled, dimension);
    if (coarse.size() != shifted.size()) throw std::invalid_argument("the coarse polygon has another number of points");
    for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] = coarse[i] - shifted[i];
    std::vector<double> points = product(matrix_, shifted, dimension);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += filled[i];
    return points;
}

} // namespace internode
