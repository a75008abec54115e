// SPDX-License-Identifier: MIT
//
// A grid of control points with a grammar along each side: refined, then moved onto its surface with normals.

#include <internode/internode.h>

#include <cstdio>
#include <vector>

/// The knots of a clamped side of so many intervals of one length.
internode::Knots clamped_side(const internode::IntervalSystem& system, int degree, std::size_t intervals) {
    const internode::Word domain(intervals, internode::to_symbol(0));
    return internode::make_knots(system, {degree, internode::Ends::Open, internode::clamped(domain, degree)})
        .knots.value();
}

int main() {
    const auto system = [](const char* text) {
        return internode::validate(*internode::parse_grammar(text, "example").grammar).system.value();
    };
    std::vector<double> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j)
            for (const double number : {double(i), double(j), double(i * j % 3)}) points.push_back(number);

    internode::GridData data{clamped_side(system("A -> A A"), 3, 1), clamped_side(system("B -> B B B"), 2, 1), 3, false,
                             points};
    const internode::CheckedGrid checked = internode::make_grid(data);
    for (const std::string& problem : checked.problems) std::printf("%s\n", problem.c_str());
    if (!checked.grid) return 1;

    const internode::Grid fine = internode::refine(*checked.grid, 2, 1);
    const internode::SurfaceLimit limit = internode::surface_limit(fine, internode::Normals::Unit);
    std::printf("%zu points, %zu faces\n", limit.sheet.rows * limit.sheet.columns, limit.sheet.faces());
    for (std::size_t c = 0; c < 3; ++c)
        std::printf("%.4f (normal %.4f)\n", limit.sheet.points[c], limit.sheet.normals[c]);
}
