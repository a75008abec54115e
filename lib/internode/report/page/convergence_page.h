// SPDX-License-Identifier: MIT
//
// The convergence report as one self-contained HTML page: the curve, the error and its guaranteed envelope against the
// number of points, the ratio of successive errors against 1/ρ², the exact constants, and a table.
//
// No script, no request, no font from elsewhere: the page's own policy forbids them (docs/promises.md, P19).

#pragma once

#include "internode/curve/convergence.h"
#include "internode/report/generator.h"

#include <string>

namespace internode {

struct ConvergencePage {
    const Convergence& convergence;
    const IntervalSystem& system;
    std::string curve_name; ///< the curve's file: "iceland-coast"; may be empty
    std::string picture;    ///< curve_picture() for a page; may be empty
    Generator generator;
};

[[nodiscard]] std::string convergence_page(const ConvergencePage& page);

} // namespace internode
