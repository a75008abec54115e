// SPDX-License-Identifier: MIT

#include "internode/spline/blossom.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace internode {

std::vector<Number> knots(const IntervalSystem& system, WordView word) {
    std::vector<Number> result;
    result.reserve(word.size() + 1);
    result.emplace_back(0);
    for (const Symbol symbol : word) {
        if (symbol != zero_interval && !system.occurs(symbol))
            throw std::invalid_argument("a symbol that the axiom can never produce has no length");
        result.push_back(result.back() + system.length(symbol));
    }
    return result;
}

// Level r = 1 … d of the triangle takes argument x_r and makes, for i = j-d+r … j,
//     p_i^r = (1 - α) p_{i-1}^{r-1} + α p_i^{r-1},   α = (x_r - τ_i) / (τ_{i+d-r+1} - τ_i).
// With s = i-j+d in r … d, τ_i is knots_[s-1] and τ_{i+d-r+1} is knots_[s+d-r]. These differences contain
// [τ_j, τ_{j+1}), so they are positive whatever multiplicities surround it.

PolynomialPiece::PolynomialPiece(std::vector<Number> local_knots)
    : knots_(std::move(local_knots)) {
    const std::size_t d = degree();
    if (d == 0 || knots_.size() % 2 != 0) throw std::invalid_argument("a piece of degree d has 2d knots, d >= 1");
    if (!std::is_sorted(knots_.begin(), knots_.end())) throw std::invalid_argument("the knots of a piece ascend");
    if (knots_[d - 1] == knots_[d]) throw std::invalid_argument("the interval of a piece is not empty");
    reciprocals_.reserve(d * (d + 1) / 2);
    for (std::size_t r = d; r >= 1; --r)
        for (std::size_t s = r; s <= d; ++s) reciprocals_.push_back(Number(1) / (knots_[s + d - r] - knots_[s - 1]));
}

std::vector<Number> PolynomialPiece::weights(std::span<const Number> arguments) const {
    const std::size_t d = degree();
    if (arguments.size() != d) throw std::invalid_argument("a blossom of degree d has d arguments");
    std::vector<Number> result(d + 1);
    result[d] = Number(1);
    // From the tip of the triangle down: result[s] holds the weight of p_i^r, then of p_i^{r-1}.
    auto reciprocal = reciprocals_.begin();
    for (std::size_t r = d; r >= 1; --r) {
        for (std::size_t s = r; s <= d; ++s, ++reciprocal) {
            const Number right = (arguments[r - 1] - knots_[s - 1]) * *reciprocal * result[s];
            result[s - 1] += result[s] - right;
            result[s] = right;
        }
    }
    assert(reciprocal == reciprocals_.end());
    return result;
}

std::vector<Number> blossom_weights(std::span<const Number> local_knots, std::span<const Number> arguments) {
    return PolynomialPiece({local_knots.begin(), local_knots.end()}).weights(arguments);
}

} // namespace internode
