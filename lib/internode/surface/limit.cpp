// SPDX-License-Identifier: MIT
//
// First every row of the grid at the stops of v, then whole rows at the stops of u: a row is one point of many
// coordinates there.

#include "internode/surface/limit.h"

#include "internode/curve/gather.h"
#include "internode/surface/normal_rows.h"
#include "internode/surface/stops.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// Each row of the grid at the stops of v: N_u rows of stops.size() points.
std::vector<double> along_v(const Grid& grid, const Stops& v) {
    const std::size_t dimension = grid.dimension();
    const std::size_t row_size = grid.v().size() * dimension;
    std::vector<double> result(grid.u().size() * v.stops.size() * dimension);
    double* out = result.data();
    for (std::size_t i = 0; i < grid.u().size(); ++i) {
        Parents parents(std::span(grid.points()).subspan(i * row_size, row_size), dimension, v.width);
        for (const Stop& stop : v.stops) {
            combine(v.position(stop), parents.rows(stop.first), dimension, out);
            out += dimension;
        }
    }
    assert(out == result.data() + result.size());
    return result;
}

/// Points of `dimension` coordinates appended as points in space.
void append_projected(const std::vector<double>& row, std::size_t dimension, bool rational,
                      std::vector<double>& points) {
    assert(dimension > 0 && row.size() % dimension == 0);
    for (std::size_t first = 0; first < row.size(); first += dimension) {
        const double divisor = rational ? row[first + dimension - 1] : 1;
        for (std::size_t c = 0; c < (rational ? dimension - 1 : dimension); ++c)
            points.push_back(row[first + c] / divisor);
    }
}

std::vector<double> parameters(const Stops& stops) {
    std::vector<double> result;
    for (const Stop& stop : stops.stops) result.push_back(stop.parameter);
    return result;
}

} // namespace

SurfaceLimit surface_limit(const Grid& grid, Normals normals) {
    return surface_limit(grid, grid, normals);
}

SurfaceLimit surface_limit(const Grid& given, const Grid& fine, Normals normals) {
    if (normals == Normals::Unit && fine.space_dimension() != 3)
        throw std::invalid_argument("only a surface in three dimensions has normals");
    const Stops u = make_stops(fine.u());
    const Stops v = make_stops(fine.v());
    SurfaceLimit limit{parameters(u), parameters(v), {}};
    Sheet& sheet = limit.sheet;
    sheet.rows = u.stops.size();
    sheet.columns = v.stops.size();
    sheet.dimension = fine.space_dimension();
    sheet.joined_rows = u.joins;
    sheet.joined_columns = v.joins;
    sheet.points.reserve(sheet.rows * sheet.columns * sheet.dimension);

    const std::vector<double> positions = along_v(fine, v);
    std::vector<double> row(v.stops.size() * fine.dimension());
    Parents parents(positions, row.size(), u.width);
    for (const Stop& stop : u.stops) {
        combine(u.position(stop), parents.rows(stop.first), row.size(), row.data());
        append_projected(row, fine.dimension(), fine.rational(), sheet.points);
    }
    assert(sheet.points.size() == sheet.rows * sheet.columns * sheet.dimension);
    if (normals == Normals::None) return limit;
    sheet.normals.reserve(sheet.rows * sheet.columns * 3);
    NormalRows rows(given, fine, v);
    for (const Stop& stop : u.stops) rows.append(stop, sheet.normals);
    assert(sheet.normals.size() == sheet.rows * sheet.columns * 3);
    return limit;
}

} // namespace internode
