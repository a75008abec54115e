// SPDX-License-Identifier: MIT

#include "internode/report/text/reversal_text.h"

#include "internode/grammar/points/print_points.h"
#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <cassert>

namespace internode {

namespace {

std::string rule_lines(const ReversalReport& report) {
    if (!report.rule) return {};
    return fmt::format("  rule     {}\n  gain     {}\n", production_text(*report.rule), to_string(gain(*report.rule)));
}

/// Finest polygon first, as it is taken apart.
std::string levels_table(const ReversalReport& report) {
    TextTable table(std::vector<Align>(4, Align::Right), 2, 2);
    table.row({"down", "points", "max error", "rms error"});
    for (std::size_t down = 0; down < report.polygons.size(); ++down) {
        std::vector<std::string> cells{std::to_string(down),
                                       std::to_string(report.polygons[down].size() / report.dimension), "-", "-"};
        if (report.rule && down > 0) {
            cells[2] = rounded(report.levels[down - 1].largest_error);
            cells[3] = rounded(report.levels[down - 1].rms_error);
        }
        table.row(std::move(cells));
    }
    return table.text();
}

} // namespace

std::string production_text(const ReverseRule& rule) {
    const PointGrammar grammar = reverse_grammar("", rule);
    return print(grammar.rules.front(), grammar);
}

std::string reversal_text(const ReversalReport& report) {
    assert(!report.polygons.empty() && report.dimension > 0);
    const std::size_t levels = report.polygons.size() - 1;
    std::string text = fmt::format("{}: {} {} down, phase {}\n\n", printable(report.name), levels,
                                   levels == 1 ? "level" : "levels", report.phase);
    text += fmt::format("  polygon  {}\n", to_string(report.fitting)) + rule_lines(report) + '\n';
    text += levels_table(report);
    text += report.rule ? "\n  errors   f - P c: the level refined by the grammar, from the one above it\n"
                        : "\n  errors   not known: the grammar says no way back\n";
    return text;
}

} // namespace internode
