// SPDX-License-Identifier: MIT

#include "bench/script_case.h"

#include "bench/ours.h"

#include "internode/io/file/output_file.h"

#include <cstdio>
#include <string>

namespace internode::bench {
namespace {

bool write_raw(const std::string& path, std::span<const double> values) {
    OutputFile file(path);
    file.write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    return !file.commit();
}

} // namespace

int write_script_case(const char* folder) {
    const CurveCase curve = fibonacci_case(1190, 7); // one knot a call: minutes for a million
    const DoubleKnots knots = double_knots(curve.knots, curve.steps);
    const Contestant ours = ours_reused("internode", curve);
    (void)ours.seconds();
    const double seconds = ours.seconds();
    const std::string prefix = std::string(folder) + '/';
    if (!write_raw(prefix + "coarse.f64", knots.coarse) || !write_raw(prefix + "inserted.f64", knots.inserted) ||
        !write_raw(prefix + "points.f64", curve.points) || !write_raw(prefix + "fine.f64", ours.points())) {
        std::fprintf(stderr, "internode_bench: cannot write to %s\n", folder);
        return 4;
    }
    std::printf("%.9g\n", seconds);
    return 0;
}

} // namespace internode::bench
