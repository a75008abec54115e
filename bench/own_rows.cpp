// SPDX-License-Identifier: MIT
//
// internode against itself: kinds of curves per multiply-add, threads, sizes, and all levels against a copy.

#include "bench/byte_cases.h"
#include "bench/ours.h"

#include "internode/stencil/levels_plan.h"

#include <thread>

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

/// Counted in bytes of the result.
template<typename Scalar>
Contestant per_byte(const std::string& name, const ByteCase& given) {
    const ByteCurve<Scalar> curve(given);
    const std::size_t count = curve.plan().output_size();
    const auto out = touched_buffer<Scalar>(count * given.dimension);
    const auto work = [=] { curve.plan().template apply<Scalar>(curve.points, curve.dimension, out->values()); };
    return {name, static_cast<double>(out->size() * sizeof(Scalar)), count, [work] { return seconds_of(work); }};
}

/// About 240 MB each.
std::vector<Contestant> bytes(Scale scale) {
    const int steps = scaled(19, scale);
    std::vector<Contestant> contestants;
    for (const ByteCase& given : byte_cases(1070, steps))
        contestants.push_back(given.in_float ? per_byte<float>(given.name, given)
                                             : per_byte<double>(given.name, given));
    add_fills(contestants, refined_points(fibonacci_case(1070, steps)));
    for (Contestant& contestant : contestants)
        if (contestant.name.starts_with("fill")) contestant.amount *= dimension * sizeof(double);
    return contestants;
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

/// Runs fill on as many parts as there are threads, side by side.
void fill_on(int threads, std::span<double> to, Fill* fill) {
    const std::size_t half = threads == 1 ? 0 : to.size() / 2;
    std::jthread other;
    if (half > 0) other = std::jthread([=] { fill(to.first(half)); });
    fill(to.subspan(half));
}

/// What one and two threads write when they compute nothing: into touched memory, or into what the call asks for.
void add_fills_on_threads(std::vector<Contestant>& contestants, std::size_t points, bool fresh) {
    const auto amount = static_cast<double>(points);
    const auto kept = std::make_shared<CoordinateBuffer<double>>();
    if (!fresh) *kept = std::move(*touched_buffer<double>(points * dimension));
    for (Fill* const fill : {fill_cached, fill_streamed})
        for (const int threads : {1, 2}) {
            const auto seconds = [=] {
                if (fresh) *kept = {};
                return wall_seconds_of([&] {
                    if (fresh) *kept = CoordinateBuffer<double>(points * dimension);
                    fill_on(threads, kept->values(), fill);
                });
            };
            const std::string name = fill == fill_cached ? "fill" : "fill-streamed";
            contestants.push_back({name + (threads == 1 ? "-one" : "-two"), amount, points, seconds});
        }
}

std::vector<Contestant> threads_fresh(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    std::vector<Contestant> contestants{ours_fresh("one-thread", curve, threads(1), Clock::Wall),
                                        ours_fresh("two-threads", curve, threads(2), Clock::Wall)};
    add_fills_on_threads(contestants, refined_points(curve), true);
    return contestants;
}

std::vector<Contestant> threads_reused(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    std::vector<Contestant> contestants{on_threads(1, curve), on_threads(2, curve)};
    add_fills_on_threads(contestants, refined_points(curve), false);
    return contestants;
}

std::vector<Contestant> threads_few_points(Scale scale) {
    const CurveCase curve = fibonacci_case(1190, scaled(9, scale));
    return {on_threads(1, curve), on_threads(2, curve)};
}

std::vector<Contestant> sizes_of(Scale scale, const std::function<Contestant(const std::string&, CurveCase)>& ours) {
    struct Size {
        std::string name;
        CurveCase curve;
    };
    std::vector<Contestant> contestants;
    for (const Size& size :
         {Size{"1M", fibonacci_case(1190, scaled(14, scale))}, Size{"10M", fibonacci_case(1070, scaled(19, scale))},
          Size{"100M", fibonacci_case(967, scaled(24, scale))}}) {
        contestants.push_back(ours(size.name, size.curve));
        contestants.back().points = nullptr;
        add_fills(contestants, refined_points(size.curve), '-' + size.name);
    }
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
            {"bytes-10M-reused", bytes},
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
