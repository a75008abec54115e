// SPDX-License-Identifier: MIT

#include "internode/report/text/masks_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/number.h"
#include "internode/text/printable.h"

#include <cassert>

namespace internode {

namespace {

constexpr std::size_t listed_lengths = 12;
constexpr std::string_view final_mark = "*";

std::string text_of(const Number& number, const IntervalSystem& system) {
    return number_text(number, system.field(), system.ratio_name());
}

enum class Style {
    Exact,
    Decimal,
    Narrow ///< decimal, and child windows are not named
};

/// A weight where many stand in a row: exact or decimal, not both.
std::string short_text(const Number& number, const IntervalSystem& system, Style style) {
    const std::string exact = exact_text(number, system.field(), system.ratio_name());
    const bool is_decimal = exact.empty() || (style != Style::Exact && !number.is_rational());
    return is_decimal ? "≈" + rounded(number.to_double()) : exact;
}

std::string header(const MaskTable& table) {
    const IntervalSystem& system = table.system;
    const std::string& name = system.grammar().name;
    std::string text = (name.empty() ? "The system" : printable(name)) + ", degree " + std::to_string(table.degree);
    text += "; " + system.ratio_name() + " = " + to_string(system.ratio().to_double());
    if (system.field().degree() > 1)
        text += ", the largest root of " + polynomial_text(system.field().minimal_polynomial());
    text = wrapped(text, 0) + "\n";
    if (system.alphabet().size() > listed_lengths) return text;
    std::string lengths;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        const Symbol symbol = to_symbol(i);
        if (!system.occurs(symbol)) continue;
        lengths += (lengths.empty() ? "lengths " : ", ") + printable(system.alphabet().name(symbol)) + " = " +
                   text_of(system.length(symbol), system);
    }
    return text + wrapped(lengths, 0) + "\n";
}

std::string choice_text(WordChoice choice) {
    switch (choice) {
    case WordChoice::Reachable:
        return "reachable from the axiom";
    case WordChoice::Persistent:
        return "that persist";
    case WordChoice::All:
    case WordChoice::Default:
        break;
    }
    return "in all";
}

std::string decompositions_text(const MaskTable& table) {
    const Alphabet& alphabet = table.system.alphabet();
    TextTable rows({Align::Left, Align::Left, Align::Left, Align::Left, Align::Left});
    for (std::size_t v = 0; v < table.masks.size(); ++v) {
        std::string word = printable(to_string(table.masks[v].word, alphabet));
        std::string is_persistent(table.graph.persistent[v] ? final_mark : "");
        std::string arrow = "->";
        for (const MaskEntry& entry : table.masks[v].entries) {
            rows.row({is_persistent, word, arrow, printable(to_string(entry.word, alphabet)),
                      text_of(entry.weight, table.system)});
            is_persistent.clear();
            word.clear();
            arrow.clear();
        }
    }
    return "\nMasks: " + std::to_string(table.masks.size()) + " decompositions " + choice_text(table.choice) +
           " (* persistent). A control point of the\nword on the left spreads over the new points on the right.\n\n" +
           rows.text();
}

/// The window with its middle interval in brackets.
std::string window_name(WordView window, const Alphabet& alphabet) {
    assert(window.size() % 2 == 1);
    const std::size_t middle = window.size() / 2;
    const std::string before = to_string(window.first(middle), alphabet);
    const std::string after = to_string(window.subspan(middle + 1), alphabet);
    return printable(before + "[" + to_string(window.subspan(middle, 1), alphabet) + "]" + after);
}

TextTable windows_table(const MaskTable& table, Style style) {
    const Alphabet& alphabet = table.system.alphabet();
    std::vector<Align> columns(5, Align::Left);
    columns.resize(columns.size() + static_cast<std::size_t>(table.degree) + 1, Align::Right);
    TextTable rows(std::move(columns));
    const auto add = [&](std::vector<std::string> cells, const std::vector<Number>& weights) {
        for (const Number& weight : weights) cells.push_back(short_text(weight, table.system, style));
        rows.row(std::move(cells));
    };
    for (const WindowRow& row : table.windows) {
        std::string is_persistent(row.persistent ? final_mark : "");
        std::string name = window_name(row.stencils.window, alphabet);
        for (std::size_t c = 0; c < row.children.size(); ++c) {
            const bool is_named = style != Style::Narrow;
            add({is_persistent, name, std::to_string(c), is_named ? "->" : "",
                 is_named ? window_name(row.stencils.child_windows[c], alphabet) : std::string()},
                row.stencils.children[c]);
            is_persistent.clear();
            name.clear();
        }
        if (!table.has_leading) continue;
        for (std::size_t z = 1; z <= row.stencils.leading.size(); ++z)
            add({"", "", "z=" + std::to_string(z), "", ""}, row.stencils.leading[z - 1]);
    }
    return rows;
}

std::string windows_text(const MaskTable& table) {
    std::string text = "\nStencils: " + std::to_string(table.windows.size()) +
                       " windows. The new point of child c of the interval in brackets takes\nthese weights from the " +
                       std::to_string(table.degree + 1) + " old points over that interval, left to right.\n";
    if (table.has_leading) text += "Row z: the new point z intervals before child 0 (ends and empty intervals).\n";
    TextTable rows = windows_table(table, Style::Exact);
    if (!rows.fits()) rows = windows_table(table, Style::Decimal);
    if (!rows.fits()) rows = windows_table(table, Style::Narrow);
    return text + "\n" + rows.text();
}

} // namespace

std::string masks_text(const MaskTable& table) {
    return header(table) + decompositions_text(table) + windows_text(table);
}

} // namespace internode
