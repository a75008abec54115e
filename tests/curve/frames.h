// SPDX-License-Identifier: MIT
//
// A curve after some steps, and its frames.

#pragma once

#include "internode/curve/limit.h"
#include "internode/curve/refinement.h"

namespace internode::tests {

inline Refinement refined(const Curve& curve, int steps) {
    Refinement refinement(curve);
    refinement.advance(steps);
    return refinement;
}

inline LimitFrames frames_of(const Curve& curve, int steps) {
    return limit_frames(curve, refined(curve, steps));
}

} // namespace internode::tests
