// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/limits.h"
#include "cli/commands/commands.h"
#include "cli/points/point_run.h"
#include "cli/shell/output.h"
#include "internode/curve/curve.h"
#include "internode/curve/knots.h"
#include "internode/interval/validity.h"
#include "internode/io/file/limits.h"
#include "internode/io/obj/obj.h"
#include "internode/io/sheet_files.h"
#include "internode/point/infer/inference.h"
#include "internode/point/limits.h"
#include "internode/report/picture/derivation_tree.h"
#include "internode/report/picture/drawn_steps.h"
#include "internode/report/picture/graph_picture.h"
#include "internode/report/picture/levels_picture.h"
#include "internode/spline/polygon_constant.h"
#include "internode/stencil/automaton.h"

#include <fmt/format.h>

#include <array>
#include <span>

namespace internode::cli {
namespace {

/// Of systems and splines.
constexpr std::array<Limit, 10> exact_limits{{
    {"class with an exact ratio (beyond: enclosures)", ValidityLimits{}.exact_class, "symbols"},
    {"degree of an exact field (beyond: enclosures)", ValidityLimits{}.field_degree, ""},
    {"degree of a spline", max_degree, ""},
    {"states of a stencil automaton", max_states, "states"},
    {"words in a table of masks", max_table_words, "words"},
    {"exact work of a table of masks or an automaton", max_table_work, "units"},
    {"words of inner intervals for the constant C*", max_inner_words, "words"},
    {"letters in the rules of a power of a grammar", max_power_letters, "letters"},
    {"letters in the rules of steps at once (masks --steps)", max_fused_letters, "letters"},
    {"points of the polygon of a matrix (masks --points)", max_matrix_points, "points"},
}};

constexpr std::array<Limit, 8> work_limits{{
    {"new points from an old one (infer)", max_inferred_arity, "points"},
    {"the same times the old points that a new one depends on", max_pattern_size, ""},
    {"cycles of a point grammar (--steps)", max_cycles, "cycles"},
    {"levels of a reversal (reverse --levels)", max_levels, "levels"},
    {"coordinates of a point in OBJ", max_obj_dimension, "coordinates"},
    {"coordinates of a point in a mesh", max_mesh_dimension, "coordinates"},
    {"vertices of a PLY file", max_ply_vertices, "vertices"},
    {"triangles of an STL file", max_stl_triangles, "triangles"},
}};

constexpr std::array<Limit, 5> picture_limits{{
    {"points of a curve in a picture (beyond: fewer steps)", max_drawn_points, "points"},
    {"words drawn on a circle", max_drawn_words, "words"},
    {"modules of a word in a derivation tree (--tree)", max_tree_row, "modules"},
    {"modules of all words in a derivation tree (--tree)", max_tree_modules, "modules"},
    {"levels in one picture", max_level_panels, "levels"},
}};

std::string row(const Limit& limit) {
    return fmt::format("{:<58} {:>12} {}\n", limit.name, limit.value, limit.unit);
}

std::string rows(std::span<const Limit> limits) {
    std::string text;
    for (const Limit& limit : limits) text += row(limit);
    return text;
}

} // namespace

ExitCode run(const LimitsOptions&, const Context&) {
    std::string text = rows(grammar_limits) + rows(point_limits) + rows(input_limits) + rows(exact_limits) +
                       rows(work_limits) + rows(picture_limits);
    text += row({"points of a refinement (--max-points)", PolygonOptions{}.max_points, "points"});
    text += row({"letters of `word` (--max-letters)", WordOptions{}.max_letters, "letters"});
    write_output("-", text);
    return ExitCode::Success;
}

} // namespace internode::cli
