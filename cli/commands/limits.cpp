// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/limits.h"
#include "cli/commands/commands.h"
#include "cli/shell/output.h"
#include "cli/points/point_run.h"
#include "internode/curve/curve.h"
#include "internode/interval/validity.h"
#include "internode/io/limits.h"
#include "internode/point/limits.h"
#include "internode/report/picture/graph_picture.h"
#include "internode/stencil/automaton.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

std::string row(std::string_view name, std::uint64_t value, std::string_view unit) {
    return fmt::format("{:<58} {:>12} {}\n", name, value, unit);
}

} // namespace

ExitCode run(const LimitsOptions&, const Context&) {
    std::string text;
    for (const auto& limit : grammar_limits) text += row(limit.name, limit.value, limit.unit);
    for (const auto& limit : point_limits) text += row(limit.name, limit.value, limit.unit);
    for (const auto& limit : input_limits) text += row(limit.name, limit.value, limit.unit);
    const ValidityLimits validity;
    text += row("class with an exact ratio (beyond: enclosures)", validity.exact_class, "symbols");
    text += row("degree of an exact field (beyond: enclosures)", validity.field_degree, "");
    text += row("degree of a spline", max_degree, "");
    text += row("states of a stencil automaton", max_states, "states");
    text += row("words in a table of masks", max_table_words, "words");
    text += row("letters in the rules of steps at once (masks --steps)", max_fused_letters, "letters");
    text += row("words drawn on a circle", max_drawn_words, "words");
    text += row("cycles of a point grammar (--steps)", max_cycles, "cycles");
    text += row("modules of a word in a derivation tree (--tree)", max_tree_row, "modules");
    text += row("modules of all words in a derivation tree (--tree)", max_tree_modules, "modules");
    text += row("levels in one picture", max_level_panels, "levels");
    text += row("points of a refinement (--max-points)", SubdivideOptions{}.polygon.max_points, "points");
    text += row("letters of `word` (--max-letters)", WordOptions{}.max_letters, "letters");
    write_output("-", text);
    return ExitCode::Success;
}

} // namespace internode::cli
