// SPDX-License-Identifier: MIT

#include "internode/report/picture/picture_legend.h"

#include "internode/report/markup.h"
#include "internode/report/picture/palette.h"
#include "internode/report/picture/svg.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

constexpr double sample_width = 40;
constexpr double row_height = 24;
constexpr double letter_width = 7.4; // pixels of a letter of 13 px sans
constexpr double entry_gap = 28;
constexpr std::size_t longest_name = 40;

struct Entry {
    std::string sample; ///< SVG at the origin, sample_width wide; empty for a remark
    std::string label;  ///< plain text
    double width = 0;
};

/// Thousands set apart: "12 345".
std::string grouped(std::size_t count) {
    std::string digits = std::to_string(count);
    for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, " ");
    return digits;
}

/// At most longest_name code points.
std::string shortened(const std::string& name) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < name.size(); ++i)
        if ((static_cast<unsigned char>(name[i]) & 0xC0U) != 0x80U && ++count > longest_name)
            return name.substr(0, i) + "…";
    return name;
}

Entry make_entry(std::string sample, std::string label) {
    const auto letters = static_cast<double>(
        std::ranges::count_if(label, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    const double width = letters * letter_width + (sample.empty() ? 0 : sample_width + 8);
    return {std::move(sample), std::move(label), width};
}

std::vector<Entry> all_entries(const std::vector<LegendEntry>& entries) {
    std::vector<Entry> all;
    for (const LegendEntry& entry : entries) {
        if (all.size() == max_legend_entries) {
            all.push_back(make_entry("", "and " + grouped(entries.size() - max_legend_entries) + " more symbols"));
            break;
        }
        all.push_back(
            make_entry("<path d=\"M0 0H40\" fill=\"none\" stroke-width=\"2.4\"" + symbol_stroke(entry.symbol) + "/>",
                       shortened(printable(entry.name)) + " × " + grouped(entry.intervals)));
    }
    all.push_back(
        make_entry("<path d=\"M0 0H40\" fill=\"none\" stroke=\"#8c8c8c\" stroke-width=\"1\"/>", "control polygon"));
    return all;
}

} // namespace

std::string symbol_stroke(Symbol symbol) {
    const SymbolStyle style = symbol_style(symbol);
    std::string text =
        " class=\"s" + std::to_string(style.colour_index) + "\" stroke=\"" + std::string(style.colour) + "\"";
    if (!style.dashes.empty()) text += " stroke-dasharray=\"" + std::string(style.dashes) + "\"";
    return text;
}

Legend picture_legend(const std::vector<LegendEntry>& entries, double width, double top) {
    assert(width > 2 * entry_gap && top >= 0);
    const std::vector<Entry> all = all_entries(entries);
    std::string text = "<g id=\"legend\" font-size=\"13\">\n";
    double y = top;
    for (std::size_t first = 0; first < all.size();) {
        std::size_t last = first;
        double row_width = 0;
        while (last < all.size() && (last == first || row_width + all[last].width <= width - 2 * entry_gap))
            row_width += all[last++].width + entry_gap;
        double x = (width - row_width + entry_gap) / 2;
        for (; first < last; ++first) {
            text += "<g transform=\"translate(" + fixed(x) + " " + fixed(y) + ")\">" + all[first].sample +
                    "<text x=\"" + (all[first].sample.empty() ? "0" : "48") + "\" y=\"4.5\" fill=\"currentColor\">" +
                    markup(all[first].label) + "</text></g>\n";
            x += all[first].width + entry_gap;
        }
        y += row_height;
    }
    return {text + "</g>\n", y - top};
}

} // namespace internode
