// SPDX-License-Identifier: MIT
//
// internode as a contestant: the plan is made anew in every run, inside the clock, unless the name says "planned".

#pragma once

#include "bench/buffers.h"

#include "internode/curve/refinement.h"

namespace internode::bench {

[[nodiscard]] inline std::size_t refined_points(const CurveCase& curve) {
    return static_cast<std::size_t>(
        refined_size(curve.knots, dimension, static_cast<std::uint64_t>(curve.steps), std::uint64_t{1} << 40).points);
}

template<typename Scalar>
void refine_into(const CurveCase& curve, std::span<const Scalar> points, std::span<Scalar> out,
                 const ApplyOptions& options) {
    refinement_plan(curve.knots, curve.steps).apply<Scalar>(points, dimension, out, options);
}

/// Which clock runs.
enum class Clock { Thread, Wall };

template<typename Work>
double timed(Clock clock, const Work& work) {
    return clock == Clock::Wall ? wall_seconds_of(work) : seconds_of(work);
}

/// Into memory that the caller has touched.
[[nodiscard]] inline Contestant ours_reused(const std::string& name, const CurveCase& curve,
                                            const ApplyOptions& options = {}, Clock clock = Clock::Thread) {
    const std::size_t count = refined_points(curve);
    const auto out = touched_buffer<double>(count * dimension);
    const auto work = [curve, out, options] { refine_into<double>(curve, curve.points, out->values(), options); };
    return {name, static_cast<double>(count), count, [=] { return timed(clock, work); },
            [out] { return std::span<const double>(out->values()); }};
}

/// The same with the plan made once, as a caller does who refines many polygons over the same knots.
[[nodiscard]] inline Contestant ours_planned(const std::string& name, const CurveCase& curve) {
    const auto plan = std::make_shared<const RefinementPlan>(refinement_plan(curve.knots, curve.steps));
    const auto out = touched_buffer<double>(plan->output_size() * dimension);
    const auto work = [=] { plan->apply<double>(curve.points, dimension, out->values()); };
    return {name, static_cast<double>(plan->output_size()), plan->output_size(), [work] { return seconds_of(work); },
            [out] { return std::span<const double>(out->values()); }};
}

/// Into memory that the call asks for.
[[nodiscard]] inline Contestant ours_fresh(const std::string& name, const CurveCase& curve,
                                           const ApplyOptions& options = {}, Clock clock = Clock::Thread) {
    const std::size_t count = refined_points(curve);
    const auto out = std::make_shared<CoordinateBuffer<double>>();
    const auto work = [curve, out, options, count] {
        *out = CoordinateBuffer<double>(count * dimension);
        refine_into<double>(curve, curve.points, out->values(), options);
    };
    const auto seconds = [=] {
        *out = {};
        return timed(clock, work);
    };
    return {name, static_cast<double>(count), count, seconds, [out] { return std::span<const double>(out->values()); }};
}

} // namespace internode::bench
