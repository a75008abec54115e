// SPDX-License-Identifier: MIT
//
// How a symbol looks: a colour and a dash pattern, so that black-and-white print and colour-blind eyes tell symbols
// apart (Nivoliers et al. 2012, Fig. 2: L red and solid, S blue and dashed).
//
// Eight colours of Paul Tol's colour-blind safe schemes and five dash patterns: lengths without a common factor, so 40
// symbols look different before the first look comes back.

#pragma once

#include "internode/word/symbol.h"

#include <string_view>

namespace internode {

inline constexpr std::size_t palette_colours = 8;
inline constexpr std::size_t palette_dashes = 5;

struct SymbolStyle {
    std::size_t colour_index = 0; ///< 0 … palette_colours - 1
    std::string_view colour;      ///< "#cc3311": on white
    std::string_view dark_colour; ///< the same hue, for a dark ground
    std::string_view dashes;      ///< SVG's stroke-dasharray in pixels; empty: solid
};

/// The style of a symbol other than `0`.
[[nodiscard]] SymbolStyle symbol_style(Symbol symbol);

} // namespace internode
