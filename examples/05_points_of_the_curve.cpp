// SPDX-License-Identifier: MIT
//
// The curve itself: points, derivatives and curvatures at its knots, by exact rows.

#include <internode/internode.h>

#include <cstdio>
#include <vector>

int main() {
    const std::vector<double> points{0, 0, 1, 2, 3, 2, 4, 0};
    const internode::Curve curve = internode::curve_from("A -> A A", points, 2, {.degree = 2});

    const internode::LimitFrames frames = internode::limit_frames(internode::Refinement(internode::refine(curve, 1)));
    for (std::size_t i = 0; i < frames.curvatures.size(); ++i)
        std::printf("t %.2f  point %.4f %.4f  derivative %.4f %.4f  curvature %.4f\n", frames.limit.parameters[i],
                    frames.limit.points[2 * i], frames.limit.points[2 * i + 1], frames.first[2 * i],
                    frames.first[2 * i + 1], frames.curvatures[i]);
}
