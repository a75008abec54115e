// SPDX-License-Identifier: MIT

#include "internode/surface/limit.h"

#include "internode/curve/gather.h"
#include "internode/surface/normal.h"
#include "internode/surface/stops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

/// What of a direction: the curve or its first derivative.
enum class Order { Position, Derivative };

std::span<const double> weights(const Stops& stops, const Stop& stop, Order order) {
    return order == Order::Position ? stops.position(stop) : stops.derivative(stop);
}

/// Each row of the grid at the stops of v: N_u rows of stops.size() points.
std::vector<double> along_v(const Grid& grid, const Stops& v, Order order) {
    const std::size_t dimension = grid.dimension();
    const std::size_t row_size = grid.v().size() * dimension;
    std::vector<double> result(grid.u().size() * v.stops.size() * dimension);
    double* out = result.data();
    for (std::size_t i = 0; i < grid.u().size(); ++i) {
        Parents parents(std::span(grid.points()).subspan(i * row_size, row_size), dimension, v.width);
        for (const Stop& stop : v.stops) {
            combine(weights(v, stop, order), parents.rows(stop.first), dimension, out);
            out += dimension;
        }
    }
    return result;
}

/// A combination of whole rows.
void along_u(Parents& rows, const Stops& u, const Stop& stop, Order order, std::vector<double>& out) {
    combine(weights(u, stop, order), rows.rows(stop.first), out.size(), out.data());
}

/// Points of `dimension` coordinates appended as points in space.
void append_projected(const std::vector<double>& row, std::size_t dimension, bool rational,
                      std::vector<double>& points) {
    for (std::size_t first = 0; first < row.size(); first += dimension) {
        const double divisor = rational ? row[first + dimension - 1] : 1;
        for (std::size_t c = 0; c < (rational ? dimension - 1 : dimension); ++c)
            points.push_back(row[first + c] / divisor);
    }
}

/// The normals of one row of the sheet after the other.
class NormalRows {
public:
    NormalRows(const Grid& grid, const Stops& u, const Stops& v)
        : dimension_(grid.dimension())
        , u_(u)
        , v_(v)
        , derivatives_(along_v(grid, v, Order::Derivative))
        , rows_(derivatives_, v.stops.size() * dimension_, u.width)
        , along_u_(v.stops.size() * dimension_)
        , along_v_(along_u_.size())
        , mixed_(along_u_.size()) {
        double size = 0;
        for (const double coordinate : grid.points()) size = std::max(size, std::abs(coordinate));
        // A few roundings for each of (d+1)² products of weights at most 1.
        noise_ = 4 * static_cast<double>(u.width * v.width) * std::numeric_limits<double>::epsilon() * size;
    }

    /// `positions`: all rows of the grid at the stops of v; `row`: their combination at the stop of u.
    void append(const Stop& stop, Parents& positions, const std::vector<double>& row, std::vector<double>& normals) {
        internode::along_u(positions, u_, stop, Order::Derivative, along_u_);
        internode::along_u(rows_, u_, stop, Order::Position, along_v_);
        internode::along_u(rows_, u_, stop, Order::Derivative, mixed_);
        for (std::size_t j = 0; j < v_.stops.size(); ++j) {
            const Vector3 normal = unit_normal({at(row, j), at(along_u_, j), at(along_v_, j), at(mixed_, j), noise_,
                                                stop.from_left, v_.stops[j].from_left});
            normals.insert(normals.end(), normal.begin(), normal.end());
        }
    }

private:
    [[nodiscard]] std::span<const double> at(const std::vector<double>& row, std::size_t j) const {
        return {row.data() + j * dimension_, dimension_};
    }

    std::size_t dimension_;
    const Stops& u_;
    const Stops& v_;
    std::vector<double> derivatives_; ///< of the rows of the grid along v
    Parents rows_;
    std::vector<double> along_u_;
    std::vector<double> along_v_;
    std::vector<double> mixed_;
    double noise_ = 0;
};

std::vector<double> parameters(const Stops& stops) {
    std::vector<double> result;
    for (const Stop& stop : stops.stops) result.push_back(stop.parameter);
    return result;
}

} // namespace

SurfaceLimit surface_limit(const Grid& grid, Normals normals) {
    if (normals == Normals::Unit && grid.space_dimension() != 3)
        throw std::invalid_argument("only a surface in three dimensions has normals");
    const Stops u = make_stops(grid.u());
    const Stops v = make_stops(grid.v());
    SurfaceLimit limit{parameters(u), parameters(v), {}};
    Sheet& sheet = limit.sheet;
    sheet.rows = u.stops.size();
    sheet.columns = v.stops.size();
    sheet.dimension = grid.space_dimension();
    sheet.joined_rows = u.joins;
    sheet.joined_columns = v.joins;
    sheet.points.reserve(sheet.rows * sheet.columns * sheet.dimension);

    const std::vector<double> positions = along_v(grid, v, Order::Position);
    std::vector<double> row(v.stops.size() * grid.dimension());
    Parents parents(positions, row.size(), u.width);
    std::optional<NormalRows> normal_rows;
    if (normals == Normals::Unit) {
        normal_rows.emplace(grid, u, v);
        sheet.normals.reserve(sheet.rows * sheet.columns * 3);
    }
    for (const Stop& stop : u.stops) {
        along_u(parents, u, stop, Order::Position, row);
        append_projected(row, grid.dimension(), grid.rational(), sheet.points);
        if (normal_rows) normal_rows->append(stop, parents, row, sheet.normals);
    }
    return limit;
}

} // namespace internode
