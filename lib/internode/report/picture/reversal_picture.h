// SPDX-License-Identifier: MIT
//
// A closed polygon beside what is left of it after some levels down, in several phases of the ring (Prusinkiewicz et
// al. 2003, Fig. 9). The panels have one scale, the original in grey under each approximation.

#pragma once

#include "internode/report/generator.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace internode {

struct ReversalPicture {
    struct Phase {
        std::uint64_t phase = 0;
        std::vector<double> points; ///< rows of `dimension` coordinates, the first two are drawn
    };
    std::size_t dimension = 2; ///< 1: numbers are drawn over their places in the ring
    std::vector<double> original;
    std::vector<Phase> phases;
    std::string title;
    Generator generator;
};

/// An SVG text, 960 pixels wide. \throw std::invalid_argument for an original without points
[[nodiscard]] std::string reversal_picture(const ReversalPicture& picture);

} // namespace internode
