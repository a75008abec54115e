// SPDX-License-Identifier: MIT
//
// The levels of a pyramid side by side, finest first, each in red over the fine polygon in grey.
//
// What noise blew up beyond the fine polygon is cut at the border of its panel. Numbers are drawn over their Greville
// abscissae.

#pragma once

#include "internode/report/generator.h"
#include "internode/report/pyramid_report.h"

#include <string>

namespace internode {

/// An SVG text, 960 pixels wide.
[[nodiscard]] std::string pyramid_picture(const PyramidReport& report, const Generator& generator);

} // namespace internode
