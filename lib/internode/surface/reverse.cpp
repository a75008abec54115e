// SPDX-License-Identifier: MIT
//
// A line takes its points as rows of any dimension. So all lines of one direction go at once: along v the grid is
// transposed and a column is one point of many coordinates, along u a row is one.

#include "internode/surface/reverse.h"

#include "internode/curve/reverse/hierarchy.h"
#include "internode/curve/reverse/reverse_step.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// Rows first … last - 1.
std::vector<double> rows_between(const std::vector<double>& rows, std::size_t dimension, std::size_t first,
                                 std::size_t last) {
    assert(first <= last && last * dimension <= rows.size());
    return {rows.begin() + static_cast<std::ptrdiff_t>(first * dimension),
            rows.begin() + static_cast<std::ptrdiff_t>(last * dimension)};
}

/// W and its inverse in one direction, for rows of any dimension.
class Line {
public:
    Line(const Knots& coarse, int levels, const ReverseOptions& options)
        : hierarchy_(coarse, levels)
        , options_(options) {}

    [[nodiscard]] std::size_t fine_size() const { return hierarchy_.size(hierarchy_.levels()); }

    [[nodiscard]] std::vector<double> decomposed(const std::vector<double>& points, std::size_t dimension) const {
        std::vector<double> fine = points;
        std::vector<double> coefficients = points;
        for (int level = hierarchy_.levels() - 1; level >= 0; --level) {
            const ReverseStep step(hierarchy_, level, options_);
            std::vector<double> coarse = step.coarse(fine, dimension);
            const Details details = step.details(fine, coarse, dimension);
            assert(step.coarse_size() * dimension + details.vectors.size() == fine.size());
            std::ranges::copy(details.vectors,
                              coefficients.begin() + static_cast<std::ptrdiff_t>(step.coarse_size() * dimension));
            fine = std::move(coarse);
        }
        std::ranges::copy(fine, coefficients.begin());
        return coefficients;
    }

    [[nodiscard]] std::vector<double> recomposed(const std::vector<double>& coefficients, std::size_t dimension) const {
        std::vector<double> points = rows_between(coefficients, dimension, 0, hierarchy_.size(0));
        for (int level = 0; level < hierarchy_.levels(); ++level) {
            const ReverseStep step(hierarchy_, level, options_);
            const Details details{step.inserted(),
                                  rows_between(coefficients, dimension, step.coarse_size(), step.fine_size())};
            points = step.fine(points, details, dimension);
        }
        return points;
    }

private:
    Hierarchy hierarchy_;
    ReverseOptions options_;
};

/// Rows of columns of entries, as columns of rows.
std::vector<double> transposed(std::span<const double> points, std::size_t rows, std::size_t columns,
                               std::size_t dimension) {
    assert(points.size() == rows * columns * dimension);
    std::vector<double> result(points.size());
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            std::copy_n(&points[(i * columns + j) * dimension], dimension, &result[(j * rows + i) * dimension]);
    return result;
}

using Apply = std::vector<double> (*)(const Line& line, const std::vector<double>& rows, std::size_t dimension);

/// A map of lines along v, then along u.
std::vector<double> applied(const GridHierarchy& hierarchy, std::size_t dimension, std::span<const double> points,
                            const ReverseOptions& options, Apply apply) {
    const Line u(hierarchy.u, hierarchy.levels_u, options);
    const Line v(hierarchy.v, hierarchy.levels_v, options);
    const std::size_t rows = u.fine_size();
    const std::size_t columns = v.fine_size();
    if (dimension == 0 || points.size() % dimension != 0 || points.size() / dimension % columns != 0 ||
        points.size() / dimension / columns != rows)
        throw std::invalid_argument("the points are not those of the fine grid");
    const std::vector<double> along_v = apply(v, transposed(points, rows, columns, dimension), rows * dimension);
    return apply(u, transposed(along_v, columns, rows, dimension), columns * dimension);
}

} // namespace

std::vector<double> decomposed(const GridHierarchy& hierarchy, std::size_t dimension, std::span<const double> fine,
                               const ReverseOptions& options) {
    return applied(hierarchy, dimension, fine, options,
                   [](const Line& line, const std::vector<double>& rows, std::size_t width) {
                       return line.decomposed(rows, width);
                   });
}

std::vector<double> recomposed(const GridHierarchy& hierarchy, std::size_t dimension,
                               std::span<const double> coefficients, const ReverseOptions& options) {
    return applied(hierarchy, dimension, coefficients, options,
                   [](const Line& line, const std::vector<double>& rows, std::size_t width) {
                       return line.recomposed(rows, width);
                   });
}

} // namespace internode
