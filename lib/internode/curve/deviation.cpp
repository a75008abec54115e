// SPDX-License-Identifier: MIT
//
// The interval is cut at its Greville abscissae, so that (x - ξ_i)_+ is linear on each piece. There the Bernstein
// coefficients of the spline are values of its blossom, those of the line are values on its chord, and β_i has their
// difference.

#include "internode/curve/deviation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace internode {

namespace {

/// The 2d knots of the window, 0 where the middle interval starts: summed outwards, so that they are as exact as the
/// lengths near the interval.
std::vector<double> local_knots(std::span<const double> lengths, std::size_t degree) {
    assert(degree >= 1 && lengths.size() == 2 * degree - 1);
    std::vector<double> knots(2 * degree);
    for (std::size_t i = degree - 1; i > 0; --i) knots[i - 1] = knots[i] - lengths[i - 1];
    for (std::size_t i = degree - 1; i + 1 < knots.size(); ++i) knots[i + 1] = knots[i] + lengths[i];
    return knots;
}

/// ξ of the d + 1 control points of the interval.
std::vector<double> local_abscissae(const std::vector<double>& knots, std::size_t degree) {
    std::vector<double> abscissae(degree + 1);
    for (std::size_t q = 0; q <= degree; ++q) {
        double sum = 0;
        for (std::size_t i = 0; i < degree; ++i) sum += knots[q + i];
        abscissae[q] = sum / static_cast<double>(degree);
    }
    return abscissae;
}

/// Bernstein coefficient b on [begin, end] of the piece with these control values: the blossom at d - b times begin and
/// b times end. Every step is convex, because both lie in the middle interval.
double bernstein_coefficient(std::vector<double> values, const std::vector<double>& knots, double begin, double end,
                             std::size_t b) {
    const std::size_t degree = values.size() - 1;
    assert(b <= degree && knots.size() == 2 * degree);
    for (std::size_t step = 1; step <= degree; ++step) {
        const double argument = step <= b ? end : begin;
        for (std::size_t q = degree; q >= step; --q) {
            const double low = knots[q - 1];
            const double high = knots[q + degree - step];
            values[q] = ((high - argument) * values[q - 1] + (argument - low) * values[q]) / (high - low);
        }
    }
    return values[degree];
}

DeviationPiece make_piece(const std::vector<double>& knots, const std::vector<double>& abscissae, double begin,
                          double end) {
    const std::size_t degree = abscissae.size() - 1;
    assert(degree >= 2 && begin < end);
    DeviationPiece piece{begin, end, std::vector<double>((degree + 1) * (degree - 1))};
    for (std::size_t i = 1; i < degree; ++i) {
        const double center = abscissae[i];
        std::vector<double> values(degree + 1);
        for (std::size_t q = 0; q <= degree; ++q) values[q] = std::max(abscissae[q] - center, 0.0);
        const double at_begin = std::max(begin - center, 0.0);
        const double at_end = std::max(end - center, 0.0);
        for (std::size_t b = 0; b <= degree; ++b) {
            const double part = static_cast<double>(b) / static_cast<double>(degree);
            piece.coefficients[b * (degree - 1) + i - 1] =
                bernstein_coefficient(values, knots, begin, end, b) - ((1 - part) * at_begin + part * at_end);
        }
    }
    return piece;
}

} // namespace

std::vector<DeviationPiece> deviation_pieces(std::span<const double> lengths) {
    const std::size_t degree = (lengths.size() + 1) / 2;
    assert(degree >= 2 && lengths.size() == 2 * degree - 1 && lengths[degree - 1] > 0);
    const std::vector<double> knots = local_knots(lengths, degree);
    const std::vector<double> abscissae = local_abscissae(knots, degree);
    const double length = knots[degree];
    std::vector<DeviationPiece> pieces;
    double begin = 0;
    for (const double abscissa : abscissae) {
        if (abscissa <= begin || abscissa >= length) continue;
        pieces.push_back(make_piece(knots, abscissae, begin, abscissa));
        begin = abscissa;
    }
    pieces.push_back(make_piece(knots, abscissae, begin, length));
    return pieces;
}

} // namespace internode
