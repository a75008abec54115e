// SPDX-License-Identifier: MIT
//
// internode_bench_once first-point | memory | apply CASE RUNS: figures of a fresh process, printed as one number.
//
//     first-point   seconds from a grammar's file to the points after one step, d = 3
//     memory        peak memory of the process while it refines to 24 M fresh points, over output and input
//     apply         multiply-adds of one run of a case of bench/byte_cases.h; RUNS are made, for callgrind to count

#include "bench/byte_cases.h"
#include "bench/cases.h"

#include "internode/curve/refinement.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"
#include "internode/io/file/input_file.h"
#include "internode/stencil/coordinate_buffer.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace internode::bench {
namespace {

double first_point() {
    const std::vector<double> points = control_points(20);
    const auto start = std::chrono::steady_clock::now();
    const InputText input = read_input(INTERNODE_SOURCE_DIR "/data/grammars/fibonacci.lsys");
    const IntervalSystem system = validate(parse_grammar(input.text, input.source).grammar.value()).system.value();
    const RefinementPlan plan = refinement_plan(prefix_knots(system, 3, Shape::Closed, 20), 1);
    CoordinateBuffer<double> out(plan.output_size() * dimension);
    plan.apply<double>(points, dimension, out.values());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double memory() {
    const CurveCase curve = fibonacci_case(1600, 20);
    const RefinementPlan plan = refinement_plan(curve.knots, curve.steps);
    CoordinateBuffer<double> out(plan.output_size() * dimension);
    plan.apply<double>(curve.points, dimension, out.values());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto peak = static_cast<double>(usage.ru_maxrss) * 1024; // kilobytes on Linux
    return peak / static_cast<double>((out.size() + curve.points.size()) * sizeof(double));
}

template<typename Scalar>
double multiply_adds(const ByteCase& given, int runs) {
    const ByteCurve<Scalar> curve(given);
    const RefinementPlan plan = curve.plan();
    CoordinateBuffer<Scalar> out(plan.output_size() * curve.dimension);
    for (int run = 0; run < runs; ++run)
        plan.apply<Scalar>(curve.points, curve.dimension, out.values(), {.stores = Stores::Cached});
    return static_cast<double>(out.size()) * (given.degree + 1);
}

/// Zero for a case that there is not.
double multiply_adds(std::string_view name, int runs) {
    for (const ByteCase& given : byte_cases(1190, 14))
        if (given.name == name)
            return given.in_float ? multiply_adds<float>(given, runs) : multiply_adds<double>(given, runs);
    return 0;
}

} // namespace
} // namespace internode::bench

int main(int argc, char** argv) {
    using namespace internode::bench;
    const std::string_view what = argc > 1 ? argv[1] : "";
    double figure = 0;
    if (argc == 2 && what == "first-point") figure = first_point();
    if (argc == 2 && what == "memory") figure = memory();
    if (argc == 4 && what == "apply") figure = multiply_adds(argv[2], std::stoi(argv[3]));
    if (figure > 0) return std::printf("%.9g\n", figure) > 0 ? 0 : 1;
    std::fputs("usage: internode_bench_once first-point | memory | apply CASE RUNS\n", stderr);
    return 2;
}
