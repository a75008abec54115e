// SPDX-License-Identifier: MIT

#include "internode/curve/clamping.h"

#include "internode/curve/gather.h"
#include "internode/curve/refinement.h"
#include "internode/spline/blossom.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {
namespace {

/// The exact row of clamped point k over the points place - d … place, `place` an interval of the domain that it meets.
std::vector<double> clamped_row(const Knots& knots, std::size_t k, std::size_t place) {
    const auto d = static_cast<std::size_t>(knots.degree());
    assert(place >= d && place < knots.size() && knots.word()[place] != zero_interval);
    const std::size_t first = place + 1 - d; // of the letters of the window, and of its 2d knots
    const std::vector<Number> local =
        internode::knots(knots.system(), WordView(knots.word()).subspan(first, 2 * d - 1));
    std::vector<Number> arguments;
    for (std::size_t knot = k + 1; knot <= k + d; ++knot)
        arguments.push_back(local[std::clamp(knot, d, knots.size()) - first]);
    std::vector<double> row;
    for (const Number& weight : blossom_weights(local, arguments)) row.push_back(weight.to_double());
    return row;
}

} // namespace

Knots clamped(const Knots& knots) {
    if (knots.ends() != Ends::Open) throw std::invalid_argument("a closed curve has no ends");
    CheckedKnots checked = make_knots(
        knots.system(), {knots.degree(), Ends::Open, clamped(knots.domain(), knots.degree()), knots.origin()});
    if (!checked.knots) throw std::invalid_argument("the domain cannot be clamped");
    return *std::move(checked.knots);
}

std::vector<double> clamped_points(const Knots& knots, std::size_t dimension, const std::vector<double>& points) {
    if (knots.ends() != Ends::Open) throw std::invalid_argument("a closed curve has no ends");
    if (dimension == 0 || points.size() % dimension != 0 || points.size() / dimension != knots.size())
        throw std::invalid_argument("the knots ask for another number of points");
    const auto d = static_cast<std::size_t>(knots.degree());
    const std::size_t n = knots.size();
    std::vector<double> result = points;
    for (std::size_t k = 0; k < n; ++k) {
        if (k + 1 >= d && k + d <= n) continue; // its knots lie in the domain already
        std::size_t place = std::max(k, d);
        while (knots.word()[place] == zero_interval) ++place; // the domain ends with an interval that has a length
        combine(clamped_row(knots, k, place), points.data() + (place - d) * dimension, dimension,
                result.data() + k * dimension);
    }
    return result;
}

} // namespace internode
