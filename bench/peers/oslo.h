// SPDX-License-Identifier: MIT
//
// Rows of a cubic refinement matrix from knots in doubles (the Oslo algorithm in the form of Lyche and Mørken). Fine
// point j is the blossom of the piece over the coarse interval of fine[j] at fine[j+1], fine[j+2], fine[j+3].

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace internode::bench {

/// Row j combines the four coarse points from first[j] on by weights[4 j] … weights[4 j + 3].
struct CubicRows {
    std::vector<std::size_t> first;
    std::vector<double> weights;
};

/// Of clamped knots, each with one more than four times the end value, fine ones containing the coarse.
[[nodiscard]] CubicRows cubic_rows(std::span<const double> coarse, std::span<const double> fine);

} // namespace internode::bench
