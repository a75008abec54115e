// SPDX-License-Identifier: MIT
//
// internode_bench_once first-point | memory: figures of a fresh process, printed as one number.
//
//     first-point   seconds from a grammar's file to the points after one step, d = 3
//     memory        peak memory of the process while it refines to 24 M fresh points, over output and input

#include "bench/cases.h"

#include "internode/curve/refinement.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"
#include "internode/io/file/input_file.h"
#include "internode/stencil/coordinate_buffer.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
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

} // namespace
} // namespace internode::bench

int main(int argc, char** argv) {
    const std::string_view what = argc == 2 ? argv[1] : "";
    if (what != "first-point" && what != "memory") {
        std::fputs("usage: internode_bench_once first-point | memory\n", stderr);
        return 2;
    }
    using namespace internode::bench;
    std::printf("%.9g\n", what == "memory" ? memory() : first_point());
    return 0;
}
