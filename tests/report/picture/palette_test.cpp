// SPDX-License-Identifier: MIT

#include "internode/report/picture/palette.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace internode {
namespace {

TEST(Palette, TheFirstTwoSymbolsLookAsInThePaper) {
    EXPECT_EQ(symbol_style(to_symbol(0)).dashes, "");
    EXPECT_NE(symbol_style(to_symbol(1)).dashes, "");
    EXPECT_EQ(symbol_style(to_symbol(0)).colour.substr(1, 2), "cc"); // red
    EXPECT_EQ(symbol_style(to_symbol(1)).colour.substr(5, 2), "bb"); // blue
}

TEST(Palette, FortySymbolsLookDifferent) {
    std::set<std::string> looks;
    for (std::size_t i = 0; i < palette_colours * palette_dashes; ++i) {
        const SymbolStyle style = symbol_style(to_symbol(i));
        looks.insert(std::string(style.colour) + " " + std::string(style.dashes));
    }
    EXPECT_EQ(looks.size(), palette_colours * palette_dashes);
}

TEST(Palette, CyclesForAnyNumberOfSymbols) {
    EXPECT_EQ(symbol_style(to_symbol(40)).colour, symbol_style(to_symbol(0)).colour);
    EXPECT_LT(symbol_style(to_symbol(1'000'003)).colour_index, palette_colours);
}

} // namespace
} // namespace internode
