// SPDX-License-Identifier: MIT

#include "internode/curve/limit.h"

#include "internode/curve/gather.h"
#include "internode/curve/parameter.h"
#include "internode/spline/window.h"

#include <unordered_map>

namespace internode {

namespace {

/// The d+1 rows of d+1 weights of a state's window, rounded once and kept.
class BezierTable {
public:
    explicit BezierTable(const Refinement& refinement)
        : refinement_(refinement) {}

    const std::vector<std::vector<double>>& rows(std::uint32_t state) {
        const auto [place, is_new] = rows_.try_emplace(state);
        if (is_new) place->second = make(refinement_.automaton().state(state).window);
        return place->second;
    }

private:
    std::vector<std::vector<double>> make(const Word& window) const {
        std::vector<std::vector<double>> rounded;
        for (const std::vector<Number>& row : bezier_rows(refinement_.curve().system(), window)) {
            rounded.emplace_back();
            for (const Number& weight : row) rounded.back().push_back(weight.to_double());
        }
        return rounded;
    }

    const Refinement& refinement_;
    std::unordered_map<std::uint32_t, std::vector<std::vector<double>>> rows_;
};

/// The Bézier points over the non-empty intervals of a curve's domain, one interval at a time.
class Pieces {
public:
    explicit Pieces(const Refinement& refinement)
        : curve_(refinement.curve())
        , refinement_(refinement)
        , table_(refinement)
        , parents_(curve_.points(), curve_.dimension(), refinement.automaton().width()) {}

    /// Whether an interval of the domain starts at this cell: it leads no other.
    [[nodiscard]] bool starts_at(std::size_t cell) const {
        return refinement_.automaton().state(refinement_.states()[cell]).lead == 0;
    }

    /// Appends Bézier point b of the interval that starts at the cell.
    void append(std::size_t cell, std::size_t b, std::vector<double>& points) {
        const std::size_t dimension = curve_.dimension();
        const double* rows = parents_.rows(static_cast<std::ptrdiff_t>(cell) - curve_.degree());
        points.resize(points.size() + dimension);
        combine(table_.rows(refinement_.states()[cell])[b], rows, dimension, points.data() + points.size() - dimension);
    }

private:
    const Curve& curve_;
    const Refinement& refinement_;
    BezierTable table_;
    Parents parents_;
};

/// The cells where the domain's non-empty intervals start.
std::vector<std::size_t> starts(const Curve& curve, const Pieces& pieces) {
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < curve.size(); ++cell)
        if (pieces.starts_at(cell)) cells.push_back(cell);
    return cells;
}

} // namespace

LimitPoints limit_points(const Refinement& refinement) {
    const Curve& curve = refinement.curve();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const std::vector<double> knots = knot_positions(curve);
    Pieces pieces(refinement);
    const std::vector<std::size_t> cells = starts(curve, pieces);
    LimitPoints limit;
    const auto add = [&](std::size_t cell, std::size_t b, double parameter, bool breaks) {
        limit.parameters.push_back(parameter);
        limit.break_before.push_back(breaks);
        pieces.append(cell, b, limit.points);
    };

    const bool open = curve.ends() == Ends::Open;
    // The d zeros of a break stand between two starts; of a closed curve also across the seam.
    const bool seam_breaks = !open && cells.front() + curve.size() - cells.back() == degree + 1;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool breaks = i > 0 ? cells[i] - cells[i - 1] == degree + 1 : seam_breaks;
        const double parameter = knots[cells[i]];
        if (i > 0 && breaks) add(cells[i - 1], degree, parameter, false);
        add(cells[i], 0, parameter, breaks);
    }
    if (open || seam_breaks) add(cells.back(), degree, knots[cells.back() + 1], false);
    return limit;
}

BezierSegments bezier_segments(const Refinement& refinement) {
    const Curve& curve = refinement.curve();
    Pieces pieces(refinement);
    BezierSegments segments;
    for (const std::size_t cell : starts(curve, pieces)) {
        segments.symbols.push_back(curve.word()[cell]);
        for (std::size_t b = 0; b <= static_cast<std::size_t>(curve.degree()); ++b)
            pieces.append(cell, b, segments.points);
    }
    return segments;
}

} // namespace internode
