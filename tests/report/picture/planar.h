// SPDX-License-Identifier: MIT
//
// What is drawn of a curve after some steps.

#pragma once

#include "internode/curve/refinement.h"
#include "internode/report/picture/curve_picture.h"

namespace internode::testing_report {

inline PlanarCurve planar_of(const Curve& coarse, int steps, PictureAxes axes = {}) {
    Refinement refinement(coarse);
    refinement.advance(steps);
    return planar_curve(coarse, refinement, axes);
}

} // namespace internode::testing_report
