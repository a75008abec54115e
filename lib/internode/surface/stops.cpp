// SPDX-License-Identifier: MIT
//
// Each interval with a length has a stop where it begins. Where d zeros break the surface the interval before them gets
// a stop at its end too, and so does the last one where the domain ends or breaks at its seam. The rows of both ends of
// a window are kept once.

#include "internode/surface/stops.h"

#include "internode/curve/parameter.h"
#include "internode/spline/window.h"
#include "internode/stencil/automaton.h"

#include <array>
#include <cassert>
#include <unordered_map>

namespace internode {

namespace {

/// Appends the rows of both ends of a window, each once, and knows where they are.
class RowTable {
public:
    RowTable(const IntervalSystem& system, Stops& stops)
        : system_(system)
        , stops_(stops) {}

    std::size_t row(const Word& window, bool right_end) {
        const auto [place, is_new] = rows_.try_emplace(window);
        if (is_new) place->second = append(WindowPiece(system_, window));
        return place->second[right_end ? 1 : 0];
    }

private:
    std::array<std::size_t, 2> append(const WindowPiece& piece) {
        const std::size_t d = piece.degree();
        const std::size_t next = stops_.positions.size() / stops_.width;
        append(piece.bezier(0));
        append(piece.bezier(d));
        return {next, next + 1};
    }

    void append(const std::vector<Number>& position) {
        assert(position.size() == stops_.width);
        for (const Number& weight : position) stops_.positions.push_back(weight.to_double());
    }

    const IntervalSystem& system_;
    Stops& stops_;
    std::unordered_map<Word, std::array<std::size_t, 2>, WordHash> rows_;
};

/// The cells where the domain's non-empty intervals start.
std::vector<std::size_t> interval_starts(const std::vector<CellState>& cells) {
    std::vector<std::size_t> starts;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
        if (cells[cell].lead == 0) starts.push_back(cell);
    return starts;
}

std::vector<Join> joins_of(const std::vector<Stop>& stops, bool closed) {
    std::vector<Join> joins;
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (!stops[i].after_break) joins.push_back({i - 1, i});
    if (closed && stops.size() > 1) joins.push_back({stops.size() - 1, 0});
    return joins;
}

} // namespace

Stops make_stops(const Knots& knots) {
    const std::vector<CellState> cells = cell_states(knots.word(), knots.degree(), knots.ends());
    const std::vector<double> parameters = knot_positions(knots);
    const std::vector<std::size_t> starts = interval_starts(cells);
    const auto degree = static_cast<std::size_t>(knots.degree());
    Stops result;
    result.width = degree + 1;
    RowTable table(knots.system(), result);
    const auto add = [&](std::size_t cell, double parameter, bool from_left, bool after_break) {
        result.stops.push_back({parameter, static_cast<std::ptrdiff_t>(cell) - knots.degree(),
                                table.row(cells[cell].window, from_left), from_left, after_break});
    };
    assert(!starts.empty() && starts.back() + 1 < parameters.size());
    const bool open = knots.ends() == Ends::Open;
    // The d zeros of a break stand between two starts; of closed knots also across the seam.
    const bool seam_breaks = !open && starts.front() + knots.size() - starts.back() == degree + 1;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const double parameter = parameters[starts[i]];
        const bool breaks = i > 0 && starts[i] - starts[i - 1] == degree + 1;
        if (breaks) add(starts[i - 1], parameter, true, false);
        add(starts[i], parameter, false, breaks);
    }
    if (open || seam_breaks) add(starts.back(), parameters[starts.back() + 1], true, false);
    result.joins = joins_of(result.stops, !open && !seam_breaks);
    return result;
}

} // namespace internode
