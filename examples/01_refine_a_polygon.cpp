// SPDX-License-Identifier: MIT
//
// A closed polygon, three steps closer to its curve of degree 3.

#include <internode/internode.h>

#include <array>
#include <cstdio>
#include <vector>

int main() {
    using internode::Ends;
    const std::vector<std::array<double, 2>> points{{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}};

    const std::vector<std::array<double, 2>> fine =
        internode::refine("L -> S L, S -> L", points, {.degree = 3, .ends = Ends::Circular, .word = "LSLLS"}, 3);

    for (const auto& [x, y] : fine) std::printf("%.6f %.6f\n", x, y);
}
