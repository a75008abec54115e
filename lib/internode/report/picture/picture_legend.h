// SPDX-License-Identifier: MIT
//
// The legend of a curve picture: a sample of each symbol's line, its name, and how many intervals carry it.

#pragma once

#include "internode/word/symbol.h"

#include <cstddef>
#include <string>
#include <vector>

namespace internode {

/// Symbols beyond these are counted, not shown.
inline constexpr std::size_t max_legend_entries = 40;

struct LegendEntry {
    Symbol symbol{};
    std::string name;
    std::size_t intervals = 0;
};

struct Legend {
    std::string svg;
    double height = 0; ///< pixels, margin below included
};

/// Rows of entries, centred in `width` pixels, the first one below `top`; last the control polygon and the knots.
[[nodiscard]] Legend picture_legend(const std::vector<LegendEntry>& entries, double width, double top);

/// ` class="s0" stroke="#cc3311" stroke-dasharray="…"`: the look of a symbol as attributes; pages restyle the class.
[[nodiscard]] std::string symbol_stroke(Symbol symbol);

} // namespace internode
