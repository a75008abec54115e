// SPDX-License-Identifier: MIT

#include "bench/cases.h"

#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace internode::bench {
namespace {

/// A prefix of the words that the first letter grows into.
Word prefix(const IntervalSystem& system, std::size_t count) {
    Word word{to_symbol(0)};
    while (word.size() < count) word = system.rules()(word);
    word.resize(count);
    return word;
}

/// Where the intervals of σ^steps(letter) begin, for each symbol.
std::vector<std::vector<double>> descendants(const IntervalSystem& system, int steps) {
    const Morphism rules = power(system.rules(), steps);
    const double scale = std::pow(system.ratio().to_double(), steps);
    std::vector<std::vector<double>> result;
    for (const Word& image : rules.images()) {
        std::vector<double>& starts = result.emplace_back();
        double start = 0;
        for (const Symbol letter : image) {
            starts.push_back(start / scale);
            start += system.length(letter).to_double();
        }
    }
    return result;
}

} // namespace

IntervalSystem bundled_system(std::string_view name) {
    const BundledGrammar* const bundled = find_bundled_grammar(name);
    if (bundled == nullptr) throw std::invalid_argument("no bundled grammar " + std::string(name));
    return validate(parse_grammar(bundled->text, name).grammar.value()).system.value();
}

Knots prefix_knots(const IntervalSystem& system, int degree, Shape shape, std::size_t count) {
    const auto d = static_cast<std::size_t>(degree);
    KnotsData data{degree, Ends::Open, {}};
    if (shape == Shape::Closed) data.ends = Ends::Circular;
    if (shape == Shape::Clamped)
        data.word = clamped(prefix(system, count - d), degree);
    else
        data.word = prefix(system, shape == Shape::Open ? count + d : count);
    return make_knots(system, std::move(data)).knots.value();
}

std::vector<double> control_points(std::size_t count) {
    std::vector<double> points;
    points.reserve(count * dimension);
    for (std::size_t i = 0; i < count; ++i) {
        const auto t = static_cast<double>(i);
        points.insert(points.end(), {0.02 * t + std::sin(0.41 * t), std::cos(0.29 * t), std::sin(0.73 * t + 1)});
    }
    return points;
}

CurveCase curve_case(std::string_view grammar, int degree, Shape shape, std::size_t count, int steps) {
    return {prefix_knots(bundled_system(grammar), degree, shape, count), steps, control_points(count)};
}

CurveCase fibonacci_case(std::size_t count, int steps) {
    return curve_case("fibonacci", 3, Shape::Clamped, count, steps);
}

int scaled(int steps, Scale scale) {
    return scale == Scale::Full ? steps : std::min(steps, 4);
}

DoubleKnots double_knots(const Knots& knots, int steps) {
    const IntervalSystem& system = knots.system();
    const auto degree = static_cast<std::size_t>(knots.degree());
    const std::vector<std::vector<double>> starts_of = descendants(system, steps);
    const WordView word = knots.word();
    DoubleKnots result;
    result.coarse.assign(degree, 0.0);
    result.fine.assign(degree, 0.0);
    double start = 0;
    for (const Symbol letter : word.subspan(degree, word.size() - 2 * degree)) {
        const std::vector<double>& starts = starts_of[to_index(letter)];
        result.coarse.push_back(start);
        for (const double within : starts) result.fine.push_back(start + within);
        for (const double within : std::span(starts).subspan(1)) result.inserted.push_back(start + within);
        start += system.length(letter).to_double();
    }
    result.coarse.insert(result.coarse.end(), degree + 1, start);
    result.fine.insert(result.fine.end(), degree + 1, start);
    return result;
}

} // namespace internode::bench
