// SPDX-License-Identifier: MIT

#include "internode/surface/sheet.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// Whether a curve over the knots breaks between control points k - 1 and k: d empty intervals start at k.
bool breaks_before(const Knots& knots, std::size_t k) {
    const Word& word = knots.word();
    const auto degree = static_cast<std::size_t>(knots.degree());
    for (std::size_t i = k; i < k + degree; ++i)
        if (word[i % word.size()] != zero_interval) return false;
    return true;
}

std::vector<Join> joins(const Knots& knots) {
    std::vector<Join> result;
    for (std::size_t k = 1; k < knots.size(); ++k)
        if (!breaks_before(knots, k)) result.push_back({k - 1, k});
    if (knots.ends() == Ends::Circular && knots.size() > 1 && !breaks_before(knots, 0))
        result.push_back({knots.size() - 1, 0});
    return result;
}

} // namespace

std::array<std::size_t, 4> Sheet::face(std::size_t k) const {
    assert(k < faces());
    const Join& row = joined_rows[k / joined_columns.size()];
    const Join& column = joined_columns[k % joined_columns.size()];
    return {row.from * columns + column.from, row.to * columns + column.from, row.to * columns + column.to,
            row.from * columns + column.to};
}

Sheet control_sheet(const Grid& grid) {
    Sheet sheet;
    sheet.rows = grid.u().size();
    sheet.columns = grid.v().size();
    sheet.dimension = grid.space_dimension();
    sheet.points = projected_points(grid);
    sheet.joined_rows = joins(grid.u());
    sheet.joined_columns = joins(grid.v());
    return sheet;
}

} // namespace internode
