// SPDX-License-Identifier: MIT
//
// Normals at the stops of a refined surface, from differences of the given points.
//
// S_u, S_v and S_uv are splines of their own: one degree less where the difference is taken, over the given knots. They
// are evaluated in pairs of doubles at the refined knots, along v for the d_u + 1 rows of points that a stop of u
// needs, then along u. Differences of refined points would lose their digits with every step (curve/derivatives.h).

#pragma once

#include "internode/curve/knot_walk.h"
#include "internode/curve/long_spline.h"
#include "internode/surface/grid.h"
#include "internode/surface/stops.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace internode {

/// One direction of the given grid, at the stops of the refined one.
class StopBasis {
public:
    /// Both knots outlive it.
    StopBasis(const Knots& given, const Knots& fine);

    [[nodiscard]] const Spans& spans() const { return spans_; }
    /// Goes to the next stop, which the stops of `fine` list in this order.
    void go_to(const Stop& stop);
    /// Of the given word, over which the stop lies.
    [[nodiscard]] std::size_t letter() const { return place_.letter; }
    /// The d + 1 basis functions at the stop, and the d of one degree less.
    [[nodiscard]] const std::vector<DoubleDouble>& values() const { return values_; }
    [[nodiscard]] const std::vector<DoubleDouble>& slopes() const { return slopes_; }
    /// The largest d / (t_{k+d} - t_k) over this letter: what a difference of points becomes at most.
    [[nodiscard]] double pace() const { return pace_; }

private:
    void enter();

    Spans spans_;
    KnotWalk walk_;
    KnotPlace place_;
    std::optional<LocalBasis> value_basis_; ///< over place_.letter
    std::optional<LocalBasis> slope_basis_; ///< over place_.letter, one degree less
    std::vector<DoubleDouble> values_;
    std::vector<DoubleDouble> slopes_;
    double pace_ = 0;
};

/// The normals of one row of the sheet after the other.
class NormalRows {
public:
    /// `fine` is `given` after some steps; both grids and the stops of `fine` outlive it.
    NormalRows(const Grid& given, const Grid& fine, const Stops& v);
    /// Appends the normals along v at the next stop of u.
    void append(const Stop& stop, std::vector<double>& normals);

private:
    /// A stop of v with its weights.
    struct Column {
        std::size_t letter;
        std::vector<DoubleDouble> values;
        std::vector<DoubleDouble> slopes;
        double pace;
        bool from_left;
    };

    void measure_noise();
    void enter(std::size_t letter);
    void add_row(std::ptrdiff_t row);
    [[nodiscard]] LongRows points_over(std::size_t row, std::size_t letter) const;

    const Grid& grid_;
    StopBasis u_;
    Spans spans_v_;
    std::vector<Column> columns_;
    int exponent_;                       ///< points are taken times 2^-exponent_
    double noise_u_ = 0;                 ///< a difference of neighbours along u not above this says nothing
    double noise_v_ = 0;                 ///< a difference of neighbours along v not above this says nothing
    std::ptrdiff_t last_row_ = -1;       ///< the last row of points in values_ and slopes_, not yet modulo their number
    LongRows values_;                    ///< the surface's rows over the letter of u, at the columns
    LongRows slopes_;                    ///< their derivatives along v
    LongRows values_u_;                  ///< differences of values_ along u
    LongRows slopes_u_;                  ///< differences of slopes_ along u
    std::vector<DoubleDouble> position_; ///< the surface at the stop of u and all columns
    std::vector<DoubleDouble> along_u_;
    std::vector<DoubleDouble> along_v_;
    std::vector<DoubleDouble> mixed_;
};

} // namespace internode
