// SPDX-License-Identifier: MIT

#include "internode/report/picture/palette.h"

#include <array>

namespace internode {

namespace {

constexpr std::array<std::string_view, palette_colours> colours{"#cc3311", "#0077bb", "#009988", "#e07020",
                                                                "#aa3377", "#1495c0", "#8a7500", "#555555"};
constexpr std::array<std::string_view, palette_colours> dark_colours{"#ff7a5c", "#5cb8ff", "#3fd0ba", "#ffa860",
                                                                     "#e583bd", "#7fd8f5", "#d6bf4a", "#b5b5b5"};
constexpr std::array<std::string_view, palette_dashes> dashes{"", "7 4", "11 3 2 3", "2.5 3", "14 5"};

} // namespace

SymbolStyle symbol_style(Symbol symbol) {
    const std::size_t index = to_index(symbol);
    const std::size_t colour = index % palette_colours;
    return {.colour_index = colour,
            .colour = colours[colour],
            .dark_colour = dark_colours[colour],
            .dashes = dashes[index % palette_dashes]};
}

} // namespace internode
