// SPDX-License-Identifier: MIT

#include "internode/curve/parameter.h"

#include "internode/algebra/double_double.h"

#include <algorithm>

namespace internode {

namespace {

/// a_i / ρ^s of every symbol of the word.
class Lengths {
public:
    explicit Lengths(const Knots& knots)
        : lengths_(knots.system().alphabet().size()) {
        const Number scale = pow(knots.system().ratio(), -knots.step());
        std::vector<bool> known(lengths_.size());
        for (const Symbol symbol : knots.word()) {
            if (symbol == zero_interval || known[to_index(symbol)]) continue;
            known[to_index(symbol)] = true;
            lengths_[to_index(symbol)] = to_double_double(knots.system().length(symbol) * scale);
        }
    }
    DoubleDouble operator[](Symbol symbol) const {
        return symbol == zero_interval ? DoubleDouble{} : lengths_[to_index(symbol)];
    }

private:
    std::vector<DoubleDouble> lengths_;
};

/// t_0 … t_{N+d}, of open and closed knots alike.
std::vector<DoubleDouble> long_positions(const Knots& knots) {
    const Lengths lengths(knots);
    const Word& word = knots.word();
    const auto degree = static_cast<std::size_t>(knots.degree());
    const std::size_t origin = knots.ends() == Ends::Open ? degree : 0;
    std::vector<DoubleDouble> result(knots.size() + degree + 1);
    result[origin] = to_double_double(knots.origin());
    for (std::size_t i = origin; i > 0; --i) result[i - 1] = result[i] + -lengths[word[i - 1]];
    for (std::size_t i = origin; i + 1 < result.size(); ++i) result[i + 1] = result[i] + lengths[word[i % word.size()]];
    return result;
}

} // namespace

std::vector<double> knot_positions(const Knots& knots) {
    const std::vector<DoubleDouble> exact = long_positions(knots);
    const std::size_t count = knots.ends() == Ends::Open ? exact.size() : knots.size() + 1;
    std::vector<double> positions(count);
    for (std::size_t i = 0; i < count; ++i) positions[i] = exact[i].hi;
    return positions;
}

std::vector<double> knot_positions(const Curve& curve) {
    return knot_positions(curve.knots());
}

std::vector<double> greville_abscissae(const Curve& curve) {
    const std::vector<DoubleDouble> knots = long_positions(curve.knots());
    const auto degree = static_cast<std::size_t>(curve.degree());
    std::vector<double> abscissae(curve.size());
    for (std::size_t k = 0; k < abscissae.size(); ++k) {
        // The mean of differences from the first knot: they are small, so the division costs nothing.
        const DoubleDouble first = knots[k + 1];
        DoubleDouble sum;
        for (std::size_t i = 2; i <= degree; ++i) sum = sum + (knots[k + i] + -first);
        abscissae[k] = (first + DoubleDouble{sum.hi / curve.degree(), 0}).hi;
    }
    return abscissae;
}

double interval_length(const Curve& curve, Symbol symbol) {
    if (symbol == zero_interval) return 0;
    return (curve.system().length(symbol) * pow(curve.system().ratio(), -curve.step())).to_double();
}

double largest_interval(const Curve& curve) {
    const Lengths lengths(curve.knots());
    double largest = 0;
    for (const Symbol symbol : curve.domain()) largest = std::max(largest, lengths[symbol].hi);
    return largest;
}

} // namespace internode
