// SPDX-License-Identifier: MIT

#include "internode/spline/window.h"

#include <cassert>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace internode {

// ρ times a length is the sum of the lengths that replace it: in units of the refinement the old knots are some of the
// new ones, and no number is divided by ρ.
struct WindowPiece::Refined {
    Word image;
    std::vector<Number> knots;
    std::vector<Number> local; ///< the 2d knots of the window
    std::size_t first;
    std::size_t child_count;
};

WindowPiece::Refined WindowPiece::refine(const IntervalSystem& system, WordView window) {
    if (window.size() % 2 == 0) throw std::invalid_argument("a window has 2d-1 letters");
    const std::size_t middle = window.size() / 2;
    if (window[middle] == zero_interval) throw std::invalid_argument("the middle interval of a window is not empty");
    Refined result{{}, {}, {}, 0, 0};
    std::vector<std::size_t> places{0};
    for (const Symbol symbol : window) {
        if (symbol != zero_interval && !system.occurs(symbol))
            throw std::invalid_argument("a symbol that the axiom can never produce has no length");
        const WordView image = system.rules().image(symbol);
        result.image.insert(result.image.end(), image.begin(), image.end());
        places.push_back(result.image.size());
    }
    result.knots = internode::knots(system, result.image);
    for (const std::size_t place : places) result.local.push_back(result.knots[place]);
    result.first = places[middle];
    result.child_count = places[middle + 1] - places[middle];
    return result;
}

WindowPiece::WindowPiece(Refined refined)
    : image_(std::move(refined.image))
    , knots_(std::move(refined.knots))
    , first_(refined.first)
    , child_count_(refined.child_count)
    , piece_(std::move(refined.local)) {}

WindowPiece::WindowPiece(const IntervalSystem& system, WordView window)
    : WindowPiece(refine(system, window)) {}

Word WindowPiece::child_window(std::size_t c) const {
    if (c >= child_count_) throw std::out_of_range("no such child of a window");
    assert(first_ + c + 1 >= degree() && first_ + c + degree() <= image_.size());
    const auto begin = image_.begin() + static_cast<std::ptrdiff_t>(first_ + c + 1 - degree());
    return {begin, begin + static_cast<std::ptrdiff_t>(2 * degree() - 1)};
}

std::vector<Number> WindowPiece::child(std::size_t c) const {
    if (c >= child_count_) throw std::out_of_range("no such child of a window");
    return piece_.weights({knots_.data() + first_ + c + 1, degree()});
}

std::vector<Number> WindowPiece::leading(std::size_t z) const {
    if (z > degree()) throw std::out_of_range("at most d intervals lead a window");
    assert(z <= first_ + 1);
    return piece_.weights({knots_.data() + first_ + 1 - z, degree()});
}

std::vector<Number> WindowPiece::bezier(std::size_t b) const {
    if (b > degree()) throw std::out_of_range("a piece of degree d has d+1 Bézier points");
    std::vector<Number> arguments(degree() - b, knots_[first_]);
    arguments.resize(degree(), knots_[first_ + child_count_]);
    return piece_.weights(arguments);
}

std::vector<Word> child_windows(const Morphism& rules, WordView window) {
    assert(window.size() % 2 == 1);
    const std::size_t middle = window.size() / 2;
    const Word image = rules(window);
    std::size_t first = 0; // child of the middle letter
    for (const Symbol letter : window.first(middle)) first += rules.image(letter).size();
    assert(first >= middle);
    std::vector<Word> windows;
    const std::size_t count = rules.image(window[middle]).size();
    windows.reserve(count);
    for (std::size_t c = 0; c < count; ++c) {
        const auto begin = image.begin() + static_cast<std::ptrdiff_t>(first + c - middle);
        windows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(window.size()));
    }
    return windows;
}

WindowStencils window_stencils(const IntervalSystem& system, WordView window) {
    const WindowPiece piece(system, window);
    WindowStencils result{{window.begin(), window.end()}, {}, {}, {}};
    for (std::size_t c = 0; c < piece.child_count(); ++c) {
        result.child_windows.push_back(piece.child_window(c));
        result.children.push_back(piece.child(c));
    }
    for (std::size_t z = 1; z <= piece.degree(); ++z) result.leading.push_back(piece.leading(z));
    return result;
}

std::vector<std::vector<Number>> bezier_rows(const IntervalSystem& system, WordView window) {
    const WindowPiece piece(system, window);
    std::vector<std::vector<Number>> rows;
    for (std::size_t b = 0; b <= piece.degree(); ++b) rows.push_back(piece.bezier(b));
    return rows;
}

namespace {

/// Δ of every two neighbours, weight by weight: one row fewer.
void take_differences(std::vector<std::vector<Number>>& rows) {
    assert(!rows.empty());
    for (std::size_t b = 0; b + 1 < rows.size(); ++b)
        for (std::size_t i = 0; i < rows[b].size(); ++i) rows[b][i] = rows[b + 1][i] - rows[b][i];
    rows.pop_back();
}

} // namespace

std::vector<std::vector<Number>> derivative_rows(const IntervalSystem& system, WordView window, PieceEnd end,
                                                 int order) {
    if (order < 0) throw std::invalid_argument("the order of a derivative is at least 0");
    // The m-th derivative of a Bézier curve over a length h: d! / (d-m)! h^-m times an m-th difference at its end.
    std::vector<std::vector<Number>> differences = bezier_rows(system, window);
    const std::size_t width = differences.size();
    const Number reciprocal = Number(1) / system.length(window[window.size() / 2]);
    Number factor(1);
    std::vector<std::vector<Number>> rows;
    for (std::size_t m = 0; m <= static_cast<std::size_t>(order); ++m) {
        if (m >= width) {
            rows.emplace_back(width);
            continue;
        }
        rows.push_back(end == PieceEnd::Begin ? differences.front() : differences.back());
        for (Number& weight : rows.back()) weight *= factor;
        take_differences(differences);
        factor *= reciprocal * Number(static_cast<long>(width - 1 - m));
    }
    return rows;
}

} // namespace internode
