// SPDX-License-Identifier: MIT
//
// internode against itself: kinds of curves per multiply-add, threads, sizes, and all levels against a copy.

#include "bench/ours.h"

#include "internode/stencil/levels_plan.h"

namespace internode::bench {
namespace {

/// Counted in multiply-adds. Different curves: their points are not compared.
Contestant per_multiply_add(const std::string& name, const CurveCase& curve) {
    Contestant contestant = ours_reused(name, curve);
    contestant.amount *= static_cast<double>(dimension) * (curve.knots.degree() + 1);
    contestant.points = nullptr;
    return contestant;
}

Contestant in_float(const std::string& name, const CurveCase& curve) {
    const std::size_t count = refined_points(curve);
    const auto out = touched_buffer<float>(count * dimension);
    const std::vector<float> points(curve.points.begin(), curve.points.end());
    const auto work = [=] { refine_into<float>(curve, points, out->values(), {}); };
    const double amount = static_cast<double>(count * dimension) * (curve.knots.degree() + 1);
    return {name, amount, count, [work] { return seconds_of(work); }};
}

std::vector<Contestant> kinds(Scale scale) {
    const int steps = scaled(19, scale);
    const auto fibonacci = [steps](int degree, Shape shape) {
        return curve_case("fibonacci", degree, shape, 1070, steps);
    };
    return {per_multiply_add("cubic", fibonacci(3, Shape::Clamped)),
            per_multiply_add("degree-2", fibonacci(2, Shape::Clamped)),
            per_multiply_add("degree-5", fibonacci(5, Shape::Clamped)),
            per_multiply_add("uniform", curve_case("bisection", 3, Shape::Clamped, 1223, scaled(13, scale))),
            per_multiply_add("closed", fibonacci(3, Shape::Closed)),
            per_multiply_add("open", fibonacci(3, Shape::Open)),
            in_float("float", fibonacci(3, Shape::Clamped))};
}

ApplyOptions threads(int count) {
    return {.threads = count};
}

std::vector<Contestant> stores(const CurveCase& curve,
                               Contestant (*ours)(const std::string&, const CurveCase&, const ApplyOptions&, Clock)) {
    return {ours("measured", curve, {.stores = Stores::Measured}, Clock::Thread),
            ours("cached", curve, {.stores = Stores::Cached}, Clock::Thread),
            ours("streamed", curve, {.stores = Stores::Streamed}, Clock::Thread)};
}

std::vector<Contestant> stores_reused(Scale scale) {
    return stores(fibonacci_case(1600, scaled(20, scale)), ours_reused);
}

std::vector<Contestant> stores_of_a_million(Scale scale) {
    return stores(fibonacci_case(1190, scaled(14, scale)), ours_reused);
}

std::vector<Contestant> stores_fresh(Scale scale) {
    return stores(fibonacci_case(1070, scaled(19, scale)), ours_fresh);
}

/// By the clock on the wall.
Contestant on_threads(int count, const CurveCase& curve) {
    return ours_reused(count == 1 ? "one-thread" : "two-threads", curve, threads(count), Clock::Wall);
}

std::vector<Contestant> threads_fresh(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    return {ours_fresh("one-thread", curve, threads(1), Clock::Wall),
            ours_fresh("two-threads", curve, threads(2), Clock::Wall)};
}

std::vector<Contestant> threads_reused(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    return {on_threads(1, curve), on_threads(2, curve)};
}

std::vector<Contestant> threads_few_points(Scale scale) {
    const CurveCase curve = fibonacci_case(1190, scaled(9, scale));
    return {on_threads(1, curve), on_threads(2, curve)};
}

std::vector<Contestant> sizes_of(Scale scale, const std::function<Contestant(const std::string&, CurveCase)>& ours) {
    std::vector<Contestant> contestants{ours("1M", fibonacci_case(1190, scaled(14, scale))),
                                        ours("10M", fibonacci_case(1070, scaled(19, scale))),
                                        ours("100M", fibonacci_case(967, scaled(24, scale)))};
    for (Contestant& contestant : contestants) contestant.points = nullptr;
    return contestants;
}

std::vector<Contestant> sizes(Scale scale) {
    return sizes_of(scale, [](const std::string& name, const CurveCase& curve) { return ours_reused(name, curve); });
}

std::vector<Contestant> sizes_planned(Scale scale) {
    return sizes_of(scale, [](const std::string& name, const CurveCase& curve) { return ours_planned(name, curve); });
}

std::vector<Contestant> levels(Scale scale) {
    const CurveCase curve = fibonacci_case(1190, scaled(14, scale));
    const auto plan_of = [curve] {
        const Knots& knots = curve.knots;
        return LevelsPlan(knots.system(), knots.degree(), knots.word(), knots.ends(), curve.steps);
    };
    const std::size_t count = plan_of().output_size();
    const auto out = touched_buffer<double>(count * dimension);
    const auto work = [=] { plan_of().apply<double>(curve.points, dimension, out->values()); };
    return {{"internode", static_cast<double>(count), count, [work] { return seconds_of(work); }}, memcpy_of(count)};
}

} // namespace

std::vector<Row> own_rows() {
    return {{"kinds-10M-reused", kinds},
            {"levels-reused", levels},
            {"stores-24M-reused", stores_reused},
            {"stores-1M-reused", stores_of_a_million},
            {"stores-10M-fresh", stores_fresh},
            {"threads-24M-fresh", threads_fresh},
            {"threads-24M-reused", threads_reused},
            {"threads-90k-reused", threads_few_points},
            {"sizes-reused", sizes},
            {"sizes-planned", sizes_planned}};
}

} // namespace internode::bench
