// SPDX-License-Identifier: MIT
//
// How fast control polygons approach the curve (Nivoliers et al. 2012, Theorem 3.2, with the constant made exact).
//
// The ratio of successive errors tends to 1/ρ²; over a period when the system is imprimitive, as a geometric mean.

#pragma once

#include "internode/curve/curve.h"
#include "internode/spline/polygon_constant.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace internode {

struct ConvergenceStep {
    int step = 0;
    std::uint64_t points = 0;
    double largest_interval = 0;
    double error = 0;            ///< sup ‖s - ℓ‖ (curve/distance.h)
    std::optional<double> ratio; ///< error / error of the step before; geometric mean over a period when imprimitive
    double envelope = 0;
};

struct ToleranceDepth {
    double tolerance = 0;
    std::optional<int> steps; ///< the first step whose envelope is at most the tolerance; none beyond max_depth
    bool measured =
        false; ///< whether that step was refined and its envelope computed; else extrapolated by 1/ρ² a step
};

inline constexpr int max_depth = 1'000'000;

struct BisectionStep {
    std::uint64_t points = 0;
    double error = 0;
};

struct Convergence {
    int degree = 1;
    std::vector<ConvergenceStep> steps; ///< step 0 … n
    Number expected_ratio;              ///< 1/ρ², exact
    PolygonConstant constant;           ///< C*(d), exact
    std::optional<ToleranceDepth> depth;
    std::vector<BisectionStep> bisection; ///< the same curve bisected uniformly, up to about as many points
};

struct ConvergenceOptions {
    int steps = 6;
    std::optional<double> tolerance; ///< > 0
    std::uint64_t max_points = 100'000'000;
    std::uint64_t search_points = 1'000'000; ///< beyond the last step, how far a tolerance is pursued by refining
};

/// \throw std::invalid_argument for negative steps, a tolerance that is not positive and finite; std::length_error when
/// a step would exceed max_points
[[nodiscard]] Convergence measure_convergence(const Curve& curve, const ConvergenceOptions& options);

/// How many points uniform bisection needs for the error of the last step, to set against the points of that step. It
/// is counted from its last step with at least that error, as errors fall with the square of the points. Empty when an
/// error is 0.
[[nodiscard]] std::optional<double> bisection_points(const Convergence& convergence);

} // namespace internode
