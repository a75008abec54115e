// SPDX-License-Identifier: MIT
//
// A polygon taken apart into a coarse one and details, put together again from the longest of them, and written to a
// file that is there whole or not at all.

#include <internode/internode.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

/// A closed curve of 40 points with a ripple.
std::vector<double> rippled(std::size_t points) {
    std::vector<double> result;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(points);
        const double radius = 10 + std::cos(7 * angle);
        result.push_back(radius * std::cos(angle));
        result.push_back(radius * std::sin(angle));
    }
    return result;
}

int main(int count, char** arguments) {
    const std::vector<double> coarse_ring(10, 0.);
    const internode::Curve ring =
        internode::curve_from("L -> S L, S -> L", coarse_ring, 2, {.ends = internode::Ends::Circular, .word = "LSLLS"});
    const std::vector<double> fine = rippled(internode::refine(ring, 4).size());

    const internode::Analysis analysis = internode::analyse(ring.knots(), 4, 2, fine);
    const internode::Pyramid kept = internode::with_longest(analysis.pyramid, 12);
    const std::vector<double> again = internode::synthesise(kept).back();
    std::printf("%zu points; %zu points and %zu details give them back within %.3f\n", fine.size() / 2,
                kept.coarse.size(), internode::detail_count(kept), internode::polygon_error(fine, again, 2).largest);

    internode::OutputFile file(count > 1 ? arguments[1] : "/dev/null");
    internode::write_csv(file, {2, again});
    if (const auto error = file.commit()) {
        std::printf("%s\n", error->message.c_str());
        return 1;
    }
}
