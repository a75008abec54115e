// SPDX-License-Identifier: MIT
//
// What is drawn of a curve after some steps.

#pragma once

#include "internode/report/picture/curve_picture.h"
#include "tests/curve/frames.h"

namespace internode::testing_report {

inline PlanarCurve planar_of(const Curve& coarse, int steps, PictureAxes axes = {}) {
    return planar_curve(coarse, tests::refined(coarse, steps), axes);
}

} // namespace internode::testing_report
