// SPDX-License-Identifier: MIT

#include "internode/spline/polygon_constant.h"

#include "internode/interval/decomposition_graph.h"
#include "internode/spline/blossom.h"

#include <cassert>
#include <stdexcept>

namespace internode {

Number polygon_constant(const IntervalSystem& system, WordView inner) {
    if (inner.empty()) return {};
    // Σ_{i<j} (t_i - t_j)² = d Σ t_i² - (Σ t_i)².
    const std::vector<Number> inner_knots = knots(system, inner);
    Number sum;
    Number squares;
    for (const Number& knot : inner_knots) {
        sum += knot;
        squares += knot * knot;
    }
    const long d = static_cast<long>(inner_knots.size());
    return (Number(d) * squares - sum * sum) / Number(2 * d * d * (d - 1));
}

PolygonConstant largest_polygon_constant(const IntervalSystem& system, int degree) {
    if (degree < 1) throw std::invalid_argument("a degree is at least 1");
    if (degree == 1) return {};
    const auto letters = static_cast<std::size_t>(degree) - 1;
    PolygonConstant result;
    for (const Word& word : word_graph(system, letters, WordChoice::Persistent, max_inner_words).words) {
        Number value = polygon_constant(system, word);
        if (value > result.value) result = {std::move(value), word};
    }
    assert(!result.word.empty() && "knots of positive lengths are apart, so no constant is 0");
    return result;
}

} // namespace internode
