// SPDX-License-Identifier: MIT
//
// internode_bench --list | --check | --case FOLDER | --row NAME [options of Google Benchmark]
//
// A row a process, so that memory and its pages are those of the row. Every contestant runs once first; when two give
// different points nothing is measured.

#include "bench/rows.h"
#include "bench/script_case.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace internode::bench {
namespace {

/// Runs of one repetition: about so many points.
constexpr std::size_t points_a_repetition = 20'000'000;

int list() {
    for (const Row& row : all_rows()) std::printf("%s\n", row.name.c_str());
    return 0;
}

double checked(const Row& row, const std::vector<Contestant>& contestants) {
    for (const Contestant& contestant : contestants) (void)contestant.seconds();
    const double apart = disagreement(contestants);
    if (!(apart <= tolerance)) std::fprintf(stderr, "%s: points differ by %.3g\n", row.name.c_str(), apart);
    return apart;
}

int check() {
    bool agree = true;
    for (const Row& row : all_rows()) agree = checked(row, row.make(Scale::Small)) <= tolerance && agree;
    return agree ? 0 : 1;
}

void measure(const Row& row, const Contestant& contestant) {
    const std::size_t runs = std::clamp<std::size_t>(points_a_repetition / contestant.point_count, 1, 200);
    const auto body = [contestant](benchmark::State& state) {
        for ([[maybe_unused]] const auto _ : state) state.SetIterationTime(contestant.seconds());
        state.counters["amount"] = contestant.amount;
        state.counters["points"] = static_cast<double>(contestant.point_count);
    };
    benchmark::RegisterBenchmark((row.name + '/' + contestant.name).c_str(), body)
        ->UseManualTime()
        ->Iterations(static_cast<benchmark::IterationCount>(runs))
        ->Unit(benchmark::kMillisecond);
}

int run(const Row& row) {
    const std::vector<Contestant> contestants = row.make(Scale::Full);
    const double apart = checked(row, contestants);
    if (!(apart <= tolerance)) return 1;
    const auto compared = std::ranges::count_if(contestants, [](const auto& one) { return one.points != nullptr; });
    benchmark::AddCustomContext("compared", std::to_string(compared));
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", apart);
    benchmark::AddCustomContext("disagreement", text);
    for (const Contestant& contestant : contestants) measure(row, contestant);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

int run_named(std::string_view name) {
    for (const Row& row : all_rows())
        if (row.name == name) return run(row);
    std::fprintf(stderr, "internode_bench: no row %.*s; --list says which\n", static_cast<int>(name.size()),
                 name.data());
    return 2;
}

int dispatch(int argc, char** argv) {
    const std::string_view what = argc > 1 ? argv[1] : "";
    if (what == "--list") return list();
    if (what == "--check") return check();
    if (what == "--case" && argc > 2) return write_script_case(argv[2]);
    if (what != "--row" || argc < 3) {
        std::fputs("usage: internode_bench --list | --check | --case FOLDER | --row NAME [--benchmark_...]\n", stderr);
        return 2;
    }
    const std::string_view name = argv[2];
    int left = argc - 2;
    benchmark::Initialize(&left, argv + 2);
    return run_named(name);
}

} // namespace
} // namespace internode::bench

int main(int argc, char** argv) {
    return internode::bench::dispatch(argc, argv);
}
