// SPDX-License-Identifier: MIT
//
// What the contestants refine: knots over bundled grammars, control points, and the same knots as doubles for peers.

#pragma once

#include "internode/curve/knots.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace internode::bench {

/// Full as the table says; Small for a check of the contestants that takes a second.
enum class Scale { Full, Small };

enum class Shape { Clamped, Open, Closed };

/// Points of every contestant have so many coordinates.
inline constexpr std::size_t dimension = 3;

[[nodiscard]] IntervalSystem bundled_system(std::string_view name);

/// `count` control points over a prefix of a word of the grammar's first letter.
[[nodiscard]] Knots prefix_knots(const IntervalSystem& system, int degree, Shape shape, std::size_t count);

/// Rows of three coordinates, the same everywhere: on a wound curve without symmetries.
[[nodiscard]] std::vector<double> control_points(std::size_t count);

/// A curve to be refined by `steps` steps.
struct CurveCase {
    Knots knots;
    int steps;
    std::vector<double> points;
};
[[nodiscard]] CurveCase curve_case(std::string_view grammar, int degree, Shape shape, std::size_t count, int steps);
/// The case of most rows: cubic, clamped, Fibonacci.
[[nodiscard]] CurveCase fibonacci_case(std::size_t count, int steps);
/// Steps that the scale allows.
[[nodiscard]] int scaled(int steps, Scale scale);

/// Clamped knots as peers take them, before and after the steps; ascending.
struct DoubleKnots {
    std::vector<double> coarse;   ///< count + degree + 1
    std::vector<double> fine;     ///< the same of the refined curve
    std::vector<double> inserted; ///< what fine has and coarse has not
};
[[nodiscard]] DoubleKnots double_knots(const Knots& knots, int steps);

} // namespace internode::bench
