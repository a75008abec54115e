// SPDX-License-Identifier: MIT
//
// Points come from rows of the refined curve, one table of them for each window; derivatives come from the given curve
// at the same knots, which a walk through both words finds.

#include "internode/curve/limit.h"

#include "internode/curve/derivatives.h"
#include "internode/curve/frame.h"
#include "internode/curve/gather.h"
#include "internode/curve/parameter.h"
#include "internode/spline/window.h"

#include <cassert>
#include <unordered_map>
#include <utility>

namespace internode {

namespace {

using Rows = std::vector<std::vector<double>>;

Rows rounded(const std::vector<std::vector<Number>>& exact) {
    Rows rows;
    for (const std::vector<Number>& row : exact) {
        rows.emplace_back();
        for (const Number& weight : row) rows.back().push_back(weight.to_double());
    }
    return rows;
}

/// The rows of d+1 weights of a window that `make` gives, rounded once for each state and kept.
template<typename Make>
class RowTable {
public:
    RowTable(const Refinement& refinement, Make make)
        : refinement_(refinement)
        , make_(std::move(make)) {}

    const Rows& rows(std::uint32_t state) {
        const auto [place, is_new] = rows_.try_emplace(state);
        if (is_new) place->second = rounded(make_(refinement_.automaton().state(state).window));
        return place->second;
    }

private:
    const Refinement& refinement_;
    Make make_;
    std::unordered_map<std::uint32_t, Rows> rows_;
};

/// Rows 0 … d of the Bézier points.
auto bezier_table(const Refinement& refinement) {
    return RowTable(refinement,
                    [system = refinement.curve().system()](const Word& window) { return bezier_rows(system, window); });
}

/// The control points over the non-empty intervals of a curve's domain, one interval at a time, combined by rows.
class Pieces {
public:
    explicit Pieces(const Refinement& refinement)
        : curve_(refinement.curve())
        , refinement_(refinement)
        , parents_(curve_.points(), curve_.dimension(), refinement.automaton().width()) {}

    /// Whether an interval of the domain starts at this cell: it leads no other.
    [[nodiscard]] bool starts_at(std::size_t cell) const {
        return refinement_.automaton().state(state(cell)).lead == 0;
    }
    [[nodiscard]] std::uint32_t state(std::size_t cell) const { return refinement_.states()[cell]; }

    /// Appends the combination by `row` of the control points over the interval that starts at the cell.
    void append(std::size_t cell, const std::vector<double>& row, std::vector<double>& points) {
        assert(row.size() == refinement_.automaton().width());
        const std::size_t dimension = curve_.dimension();
        const double* parents = parents_.rows(static_cast<std::ptrdiff_t>(cell) - curve_.degree());
        points.resize(points.size() + dimension);
        combine(row, parents, dimension, points.data() + points.size() - dimension);
    }

private:
    const Curve& curve_;
    const Refinement& refinement_;
    Parents parents_;
};

/// The cells where the domain's non-empty intervals start.
std::vector<std::size_t> starts(const Curve& curve, const Pieces& pieces) {
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < curve.size(); ++cell)
        if (pieces.starts_at(cell)) cells.push_back(cell);
    assert(!cells.empty());
    return cells;
}

/// Calls add(cell, end) for every distinct knot, breaks twice, after it has put down parameter and break: the knot
/// where the interval of that cell begins or ends.
template<typename Add>
void for_each_knot(const Curve& curve, const Pieces& pieces, LimitPoints& limit, Add add) {
    const auto degree = static_cast<std::size_t>(curve.degree());
    const std::vector<double> knots = knot_positions(curve);
    const std::vector<std::size_t> cells = starts(curve, pieces);
    assert(cells.back() + 1 < knots.size());
    const auto visit = [&](std::size_t cell, PieceEnd end, double parameter, bool breaks) {
        limit.parameters.push_back(parameter);
        limit.break_before.push_back(breaks);
        add(cell, end);
    };

    const bool open = curve.ends() == Ends::Open;
    // The d zeros of a break stand between two starts; of a closed curve also across the seam.
    const bool seam_breaks = !open && cells.front() + curve.size() - cells.back() == degree + 1;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool breaks = i > 0 ? cells[i] - cells[i - 1] == degree + 1 : seam_breaks;
        const double parameter = knots[cells[i]];
        if (i > 0 && breaks) visit(cells[i - 1], PieceEnd::End, parameter, false);
        visit(cells[i], PieceEnd::Begin, parameter, breaks);
    }
    if (open || seam_breaks) visit(cells.back(), PieceEnd::End, knots[cells.back() + 1], false);
}

void add_frames(LimitFrames& frames, std::size_t dimension) {
    assert(frames.first.size() == frames.second.size() && frames.first.size() % dimension == 0);
    frames.tangents.resize(frames.first.size());
    for (std::size_t at = 0; at < frames.first.size(); at += dimension) {
        const std::span<const double> first(frames.first.data() + at, dimension);
        const std::span<const double> second(frames.second.data() + at, dimension);
        unit_tangent(first, {frames.tangents.data() + at, dimension});
        frames.curvatures.push_back(curvature(first, second));
    }
}

} // namespace

LimitPoints limit_points(const Refinement& refinement) {
    const Curve& curve = refinement.curve();
    auto table = bezier_table(refinement);
    Pieces pieces(refinement);
    LimitPoints limit;
    for_each_knot(curve, pieces, limit, [&](std::size_t cell, PieceEnd end) {
        const Rows& rows = table.rows(pieces.state(cell));
        pieces.append(cell, end == PieceEnd::Begin ? rows.front() : rows.back(), limit.points);
    });
    return limit;
}

LimitFrames limit_frames(const Curve& given, const Refinement& refinement) {
    const Curve& curve = refinement.curve();
    assert(curve.dimension() == given.dimension());
    auto table = bezier_table(refinement);
    Pieces pieces(refinement);
    Derivatives derivatives(given);
    KnotWalk walk(given.knots(), derivatives.spans(), curve.knots());
    LimitFrames frames;
    for_each_knot(curve, pieces, frames.limit, [&](std::size_t cell, PieceEnd end) {
        const Rows& rows = table.rows(pieces.state(cell));
        pieces.append(cell, end == PieceEnd::Begin ? rows.front() : rows.back(), frames.limit.points);
        derivatives.append(end == PieceEnd::Begin ? walk.next() : walk.end(), frames.first, frames.second);
    });
    add_frames(frames, curve.dimension());
    return frames;
}

LimitFrames limit_frames(const Refinement& refinement) {
    return limit_frames(refinement.curve(), refinement);
}

BezierSegments bezier_segments(const Refinement& refinement) {
    const Curve& curve = refinement.curve();
    auto table = bezier_table(refinement);
    Pieces pieces(refinement);
    BezierSegments segments;
    const std::vector<std::size_t> cells = starts(curve, pieces);
    segments.symbols.reserve(cells.size());
    segments.points.reserve(cells.size() * (static_cast<std::size_t>(curve.degree()) + 1) * curve.dimension());
    for (const std::size_t cell : cells) {
        segments.symbols.push_back(curve.word()[cell]);
        for (const std::vector<double>& row : table.rows(pieces.state(cell))) pieces.append(cell, row, segments.points);
    }
    return segments;
}

} // namespace internode
