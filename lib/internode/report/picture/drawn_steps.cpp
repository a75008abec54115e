// SPDX-License-Identifier: MIT
//
// The number of points never falls from step to step, so that the last step that is drawn is found by halving: each
// count is a product of matrices, and no word is written.

#include "internode/report/picture/drawn_steps.h"

#include "internode/report/picture/svg.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

bool is_drawn(std::span<const Curve* const> curves, std::uint64_t steps) {
    std::uint64_t points = 0;
    for (const Curve* const curve : curves) {
        const RefinementSize size = refined_size(*curve, steps, max_drawn_points);
        points += size.points;
        if (size.exceeded || points > max_drawn_points) return false;
    }
    return true;
}

std::uint64_t points_after(const Curve& curve, std::uint64_t steps) {
    return refined_size(curve, steps, ~std::uint64_t{0}).points;
}

} // namespace

DrawnSteps drawn_steps(std::span<const Curve* const> curves, std::uint64_t steps) {
    std::uint64_t least = 0;    // is drawn, or else nothing is left out
    std::uint64_t most = steps; // beyond, nothing is asked for
    if (!is_drawn(curves, steps)) {
        while (least + 1 < most) {
            const std::uint64_t middle = least + (most - least) / 2;
            (is_drawn(curves, middle) ? least : most) = middle;
        }
        most = least;
    }
    assert(most <= steps);
    DrawnSteps drawn{.steps = most, .asked = steps, .points = 0};
    for (const Curve* const curve : curves) drawn.points += points_after(*curve, most);
    return drawn;
}

DrawnSteps drawn_steps(const Curve& curve, std::uint64_t steps) {
    const Curve* const only = &curve;
    return drawn_steps(std::span(&only, 1), steps);
}

std::string drawn_remark(const DrawnSteps& drawn) {
    assert(drawn.steps <= drawn.asked);
    if (drawn.steps == drawn.asked) return {};
    return fmt::format(
        "Drawn after {} of {} steps: the curve is the same, and more than {} points cannot be told apart.", drawn.steps,
        drawn.asked, max_drawn_points);
}

std::uint64_t curve_picture_bytes(const Curve& curve, std::uint64_t steps, Coordinates coordinates) {
    constexpr std::uint64_t each_point = 64; // starts and letters of pieces, their order, a refined polygon
    constexpr std::uint64_t texts = 1 << 18; // text that the sink has not taken yet
    const bool is_rational = coordinates == Coordinates::Homogeneous;
    const std::uint64_t row = curve.dimension() * sizeof(double);
    const std::uint64_t order = static_cast<std::uint64_t>(curve.degree()) + 1;
    // Bézier points in space, those divided by their weights, then in the plane.
    const std::uint64_t piece = order * (row * (is_rational ? 2 : 1) + sizeof(Point2) + sizeof(double));
    const RefinementSize refined = refined_size(curve, steps, ~std::uint64_t{0});
    return refined.bytes + refined.points * (each_point + piece) + curve.size() * (row + each_point) + texts;
}

} // namespace internode
