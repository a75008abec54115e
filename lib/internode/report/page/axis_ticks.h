// SPDX-License-Identifier: MIT
//
// Round values for the axes of a plot.

#pragma once

#include <string>
#include <vector>

namespace internode {

enum class Scale {
    Linear,
    Whole, ///< linear, ticked at whole numbers only
    Logarithmic
};

struct Tick {
    double place = 0; ///< the place on the axis: the value, or its decimal logarithm
    std::string label;
};

/// Round values between two places of an axis, least < greatest; about four to eight. Logarithmic: powers of ten, with
/// 2 and 5 times them when they are few.
[[nodiscard]] std::vector<Tick> axis_ticks(double least, double greatest, Scale scale);

} // namespace internode
