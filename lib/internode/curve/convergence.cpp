// SPDX-License-Identifier: MIT
//
// Steps are taken one at a time, because each is measured. For a tolerance the measured steps are asked first, then
// further ones while the points are few enough; beyond that the last envelope times the expected ratio 1/ρ² must do.

#include "internode/curve/convergence.h"

#include "internode/curve/distance.h"
#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace internode {

namespace {

void check(const Curve& curve, const ConvergenceOptions& options) {
    if (options.steps < 0) throw std::invalid_argument("a negative number of steps");
    if (options.tolerance && !(std::isfinite(*options.tolerance) && *options.tolerance > 0))
        throw std::invalid_argument(
            fmt::format("the tolerance must be positive and finite, not {}", *options.tolerance));
    const RefinementSize size = refined_size(curve, static_cast<std::uint64_t>(options.steps), options.max_points);
    if (size.exceeded)
        throw std::length_error(
            fmt::format("after {} steps the curve has more than {} points", options.steps, options.max_points));
}

ConvergenceStep measured_step(const Curve& curve, int step) {
    const PolygonDistance distance = polygon_distance(curve);
    ConvergenceStep result;
    result.step = step;
    result.points = curve.size();
    result.largest_interval = largest_interval(curve);
    result.error = distance.error;
    result.envelope = distance.envelope;
    return result;
}

/// The p-th root of a positive number by products alone, so that it has the same bytes on every machine.
double root(double value, std::size_t p) {
    assert(value > 0 && p >= 1);
    double low = std::min(value, 1.0);
    double high = std::max(value, 1.0);
    for (double middle = low + (high - low) / 2; low < middle && middle < high; middle = low + (high - low) / 2) {
        double power = 1;
        for (std::size_t i = 0; i < p; ++i) power *= middle;
        (power <= value ? low : high) = middle;
    }
    return low;
}

/// Over a period p the geometric mean of p successive ratios.
void fill_ratios(std::vector<ConvergenceStep>& steps, std::size_t period) {
    assert(period >= 1);
    for (std::size_t s = period; s < steps.size(); ++s) {
        const double before = steps[s - period].error;
        if (before == 0) continue;
        const double ratio = steps[s].error / before;
        steps[s].ratio = period == 1 || ratio == 0 ? ratio : root(ratio, period);
    }
}

/// The first step within the tolerance: among those measured, else by refining on, else by the expected ratio.
ToleranceDepth depth_for(double tolerance, Refinement refinement, const std::vector<ConvergenceStep>& steps,
                         const ConvergenceOptions& options, double expected_ratio) {
    assert(!steps.empty());
    ToleranceDepth depth{tolerance, std::nullopt, true};
    const auto within = [&](const ConvergenceStep& step) { return step.envelope <= tolerance; };
    if (const auto found = std::ranges::find_if(steps, within); found != steps.end()) {
        depth.steps = found->step;
        return depth;
    }
    ConvergenceStep last = steps.back();
    const std::uint64_t cap = std::min(options.max_points, options.search_points);
    while (!refined_size(refinement.curve(), 1, cap).exceeded) {
        refinement.step();
        last = measured_step(refinement.curve(), last.step + 1);
        if (!within(last)) continue;
        depth.steps = last.step;
        return depth;
    }
    depth.measured = false;
    int step = last.step;
    double envelope = last.envelope;
    for (; envelope > tolerance && step < max_depth; ++step) envelope *= expected_ratio;
    if (envelope <= tolerance) depth.steps = step;
    return depth;
}

/// The same curve over the same intervals, each of them halved at every step.
std::vector<BisectionStep> bisected(const Curve& curve, std::uint64_t target, std::uint64_t max_points) {
    CheckedCurve same = make_curve(bisection(curve.system()),
                                   {curve.degree(), curve.ends(), curve.word(), curve.dimension(), curve.points()});
    assert(same.curve);
    Refinement refinement(std::move(*same.curve));
    std::vector<BisectionStep> steps;
    while (true) {
        const Curve& current = refinement.curve();
        steps.push_back({current.size(), polygon_distance(current).error});
        if (current.size() >= target || refined_size(current, 1, max_points).exceeded) return steps;
        refinement.step();
    }
}

} // namespace

Convergence measure_convergence(const Curve& curve, const ConvergenceOptions& options) {
    check(curve, options);
    const IntervalSystem& system = curve.system();
    Convergence result;
    result.degree = curve.degree();
    result.expected_ratio = pow(system.ratio(), -2);
    result.constant = largest_polygon_constant(system, curve.degree());

    result.steps.push_back(measured_step(curve, 0));
    {
        Refinement refinement(curve);
        for (int step = 1; step <= options.steps; ++step) {
            refinement.step();
            result.steps.push_back(measured_step(refinement.curve(), step));
        }
        if (options.tolerance)
            result.depth = depth_for(*options.tolerance, std::move(refinement), result.steps, options,
                                     result.expected_ratio.to_double());
    }
    fill_ratios(result.steps, std::max<std::size_t>(system.period(), 1));
    result.bisection = bisected(curve, result.steps.back().points, options.max_points);
    return result;
}

std::optional<double> bisection_points(const Convergence& convergence) {
    if (convergence.steps.empty() || convergence.steps.back().error == 0) return std::nullopt;
    const double error = convergence.steps.back().error;
    std::optional<double> points;
    for (const BisectionStep& step : convergence.bisection)
        if (step.error >= error) points = static_cast<double>(step.points) * std::sqrt(step.error / error);
    return points;
}

} // namespace internode
