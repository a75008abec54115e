// SPDX-License-Identifier: MIT
//
// Compiled point grammars against the interval grammars that make the same points.

#include "bench/ours.h"

#include "internode/grammar/bundled.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/point/compile/compile.h"

#include <stdexcept>

namespace internode::bench {
namespace {

CompiledGrammar compiled(std::string_view name, std::size_t points) {
    const BundledGrammar* const bundled = find_bundled_grammar(name);
    if (bundled == nullptr) throw std::invalid_argument("no bundled grammar " + std::string(name));
    const ParsedPointGrammar parsed = parse_point_grammar(bundled->text, name);
    PointSettings settings;
    settings.dimension = dimension;
    const CheckedPointSystem checked = make_point_system(parsed.grammar.value(), settings);
    return compile(checked.system.value(), {points}).compiled.value();
}

/// As ours_reused: the plan is made anew in every run, inside the clock.
Contestant point_grammar(const std::string& name, std::string_view grammar, const CurveCase& curve) {
    const auto made = std::make_shared<const CompiledGrammar>(compiled(grammar, curve.points.size() / dimension));
    const std::size_t count = refined_points(curve);
    const auto out = touched_buffer<double>(count * dimension);
    const auto work = [=] { made->plan(curve.steps).apply<double>(curve.points, dimension, out->values()); };
    return {name, static_cast<double>(count), count, [work] { return seconds_of(work); },
            [out] { return std::span<const double>(out->values()); }};
}

/// S0 (17) gives every point to the cell that `A -> A A` gives it to.
std::vector<Contestant> chaikin(Scale scale) {
    const CurveCase curve = curve_case("bisection", 2, Shape::Closed, 1223, scaled(13, scale));
    return {point_grammar("point-grammar", "s0/17", curve), ours_reused("interval-grammar", curve)};
}

/// S0 (22) counts its parents from another one.
std::vector<Contestant> cubic(Scale scale) {
    const CurveCase curve = curve_case("bisection", 3, Shape::Closed, 1223, scaled(13, scale));
    Contestant points = point_grammar("point-grammar", "s0/22", curve);
    points.points = nullptr; // the same curve, from neighbouring control points
    return {points, ours_reused("interval-grammar", curve)};
}

} // namespace

std::vector<Row> point_rows() {
    return {{"chaikin-10M-reused", chaikin}, {"cubic-points-10M-reused", cubic}};
}

} // namespace internode::bench
