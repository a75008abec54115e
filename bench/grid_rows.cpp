// SPDX-License-Identifier: MIT
//
// Bicubic grids: Fibonacci along u, silver mean along v, clamped.

#include "bench/ours.h"
#include "bench/peers/separable.h"

#include "internode/surface/grid_plan.h"

namespace internode::bench {
namespace {

struct GridCase {
    CurveCase u;
    CurveCase v;
    std::vector<double> points;
};

struct Counts {
    std::size_t u, v;
};

struct Steps {
    int u, v;
};

GridCase grid_case(Counts counts, Steps steps) {
    return {fibonacci_case(counts.u, steps.u), curve_case("silver-mean", 3, Shape::Clamped, counts.v, steps.v),
            control_points(counts.u * counts.v)};
}

using Refine = std::function<void(std::span<double> out)>;

std::size_t refined_points(const GridCase& grid) {
    return bench::refined_points(grid.u) * bench::refined_points(grid.v);
}

Contestant contestant(const std::string& name, const GridCase& grid, const Refine& refine) {
    const std::size_t count = refined_points(grid);
    const auto out = touched_buffer<double>(count * dimension);
    const auto work = [=] { refine(out->values()); };
    return {name, static_cast<double>(count), count, [work] { return seconds_of(work); },
            [out] { return std::span<const double>(out->values()); }};
}

CubicRows masks_of(const CurveCase& curve) {
    const DoubleKnots knots = double_knots(curve.knots, curve.steps);
    return cubic_rows(knots.coarse, knots.fine);
}

Refine ours(const std::shared_ptr<const GridCase>& grid) {
    return [grid](std::span<double> out) {
        const GridPlan plan(grid->u.knots, grid->v.knots, grid->u.steps, grid->v.steps);
        plan.apply(grid->points, dimension, out);
    };
}

Refine ours_planned(const std::shared_ptr<const GridCase>& grid) {
    const auto plan = std::make_shared<const GridPlan>(grid->u.knots, grid->v.knots, grid->u.steps, grid->v.steps);
    return [grid, plan](std::span<double> out) { plan->apply(grid->points, dimension, out); };
}

Refine by_hand(const std::shared_ptr<const GridCase>& grid) {
    const auto u = std::make_shared<const CubicRows>(masks_of(grid->u));
    const auto v = std::make_shared<const CubicRows>(masks_of(grid->v));
    const auto between = touched_buffer<double>(grid->u.knots.size() * v->first.size() * dimension);
    return [=](std::span<double> out) { refine_separable(*u, *v, grid->points, between->values(), out); };
}

std::vector<Contestant> contest(const GridCase& grid) {
    const auto given = std::make_shared<const GridCase>(grid);
    std::vector<Contestant> contestants{contestant("internode", grid, ours(given)),
                                        contestant("internode-planned", grid, ours_planned(given)),
                                        contestant("separable", grid, by_hand(given)), memcpy_of(refined_points(grid))};
    add_fills(contestants, refined_points(grid));
    return contestants;
}

std::vector<Contestant> middle(Scale scale) {
    return contest(grid_case({113, 90}, {scaled(5, scale), scaled(3, scale)}));
}

std::vector<Contestant> large(Scale scale) {
    return contest(grid_case({107, 63}, {scaled(8, scale), scale == Scale::Full ? 5 : 2}));
}

} // namespace

std::vector<Row> grid_rows() {
    return {{"grid-1.5M-reused", middle}, {"grid-24M-reused", large}};
}

} // namespace internode::bench
