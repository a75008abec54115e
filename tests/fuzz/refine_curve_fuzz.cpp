// SPDX-License-Identifier: MIT
//
// Any bytes as a file of polygons, to the refined curves and their limits: refused with a sentence, or refined to the
// number of points that was foretold. The knots keep their origin and stay finite.

#include "internode/curve/limit.h"
#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"
#include "internode/input/polygon_file.h"
#include "internode/input/settled_curve.h"
#include "tests/fuzz/small_inputs.h"

#include <cmath>

namespace {

using namespace internode;
using fuzz::require;

constexpr int steps = 2;

void require_refined(const Curve& curve) {
    if (curve.degree() > 4 || curve.word().size() > 200) return;
    const Curve fine = refine(curve, steps);
    require(fine.size() == refined_size(curve, steps, 1'000'000).points);
    require(fine.knots().origin() == curve.knots().origin());
    for (const double knot : knot_positions(fine)) require(std::isfinite(knot));
    Refinement refinement(curve);
    refinement.advance(steps);
    const LimitPoints limit = limit_points(refinement);
    require(!limit.parameters.empty() && limit.points.size() == limit.parameters.size() * curve.dimension());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Chosen chosen = fuzz::chosen(data, size);
    const Settled<std::vector<InputPolygon>> read = polygons_of_file(chosen.text, "fuzz.csv");
    require(read.value.has_value() == read.refusal.errors.empty());
    if (!read.value || read.value->size() > 4) return 0;
    for (const InputPolygon& polygon : *read.value) {
        if (!fuzz::is_small(polygon)) continue;
        const Settled<SettledCurve> curve =
            settle_curve(fuzz::system_of(chosen.choice), polygon, fuzz::options_of(chosen.choice));
        require(curve.value.has_value() == curve.refusal.errors.empty());
        if (curve.value)
            require_refined(curve.value->curve);
        else
            require(!to_string(placed(curve.refusal, polygon).errors).empty());
    }
    return 0;
}
