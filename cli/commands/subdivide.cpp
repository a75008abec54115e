// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/intervals/curve_output.h"
#include "cli/intervals/limit_output.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "cli/points/picture_axes.h"
#include "cli/arguments/places.h"
#include "cli/arguments/point_options.h"
#include "cli/intervals/polygon.h"
#include "internode/curve/refinement.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/io/csv.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/report/picture/curve_picture.h"
#include "internode/text/number.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

/// What --plan says, and what is checked before any work.
RefinementSize planned(const Curve& curve, const SubdivideOptions& options) {
    const RefinementSize size = refined_size(curve, options.steps, options.polygon.max_points);
    if (size.exceeded)
        throw failure(ExitCode::Refused,
                      fmt::format("{} steps give more than {} points", options.steps, options.polygon.max_points),
                      "fewer steps, or a larger --max-points");
    return size;
}

void print_plan(const LoadedCurve& loaded, const SubdivideOptions& options) {
    const RefinementSize size = planned(loaded.curve, options);
    const Refinement refinement(loaded.curve);
    const std::uint64_t points = size.points * loaded.curve.dimension() * sizeof(double);
    const std::uint64_t divided = loaded.coordinates == Coordinates::Homogeneous ? points : 0; // a copy, for output
    write_output("-", fmt::format("points {}\nbytes of points {}\nbytes of memory {}\nstates {}\nrows {}\n",
                                  size.points, points, size.bytes + divided, refinement.automaton().state_count(),
                                  refinement.automaton().row_count()));
}

std::vector<std::string> column_names(const LoadedCurve& loaded) {
    return loaded.columns.empty() ? coordinate_names(loaded.space_dimension()) : loaded.columns;
}

bool has_weights(const LoadedCurve& loaded) {
    return loaded.coordinates == Coordinates::Homogeneous;
}

/// A polygon in OBJ knows no weights; elsewhere they are the last column, or the key "weights".
void write_polygon(Sink& sink, const std::string& format, const Curve& curve, const LoadedCurve& loaded,
                   const Context& context) {
    const bool weighted = has_weights(loaded) && format != "obj";
    std::vector<double> divided;
    if (weighted) divided = projected(curve.points(), curve.dimension());
    if (has_weights(loaded) && !weighted) divided = projected_points(curve.points(), curve.dimension());
    const PointsView points{loaded.space_dimension() + (weighted ? 1 : 0),
                            has_weights(loaded) ? divided : curve.points()};
    std::vector<std::string> columns = column_names(loaded);
    if (weighted) columns.emplace_back("w");
    if (format == "csv")
        write_csv(sink, points, {columns, {}});
    else if (format == "npy")
        write_npy(sink, points);
    else if (format == "obj")
        write_obj(sink, points, curve.ends(),
                  std::vector<std::string>{"internode " + generator(context).version, context.command_line});
    else
        write_curve(sink, curve, points, weighted, context);
}

void check_format(const SubdivideOptions& options, const std::string& format, const LoadedCurve& loaded) {
    const std::size_t dimension = loaded.space_dimension();
    if (format == "obj" && dimension > max_obj_dimension)
        throw failure(ExitCode::Refused,
                      fmt::format("OBJ has at most {} coordinates, the points have {}", max_obj_dimension, dimension),
                      "use CSV, JSON or NPY");
    if (options.derivatives && !options.limit)
        throw failure(ExitCode::Usage, "--derivatives belongs to --limit", "add --limit");
    if (options.derivatives && format != "csv" && format != "npy")
        throw failure(ExitCode::Usage, fmt::format("--derivatives has no {} form", format), "use CSV or NPY");
    if (options.derivatives && has_weights(loaded))
        throw failure(ExitCode::Refused, "the derivatives of curves with weights are not computed");
    if (options.limit && format == "json")
        throw failure(ExitCode::Usage, "points of the curve have no word: --limit has no JSON form",
                      "use CSV, NPY or OBJ; SVG always draws the curve");
    if (format == "svg" && dimension == 1 && has_weights(loaded))
        throw failure(ExitCode::Refused, "a curve of one coordinate and a weight has no picture", "use CSV or JSON");
}

std::string picture_title(const SubdivideOptions& options, const LoadedCurve& loaded) {
    return fmt::format("{} under {}, degree {}, {} {}", loaded.source,
                       display_name(loaded.curve.system().grammar(), options.grammar), loaded.curve.degree(),
                       options.steps, options.steps == 1 ? "step" : "steps");
}

} // namespace

ExitCode run(const SubdivideOptions& options, const Context& context) {
    if (options.is_grid()) {
        refuse_point_options(options.point);
        return subdivide_grid(options, context);
    }
    const LoadedText grammar = load_grammar_text(options.grammar);
    if (kind_of(grammar.text) == GrammarKind::Points) return subdivide_points(grammar, options, context);
    refuse_point_options(options.point);
    require_polygon(options.polygon);
    const std::string format = chosen_format(options.output, {"csv", "json", "npy", "obj", "svg"}, "csv");
    const IntervalSystem system = load_system(grammar, options.grammar);
    const LoadedCurve loaded = load_curve(system, options.polygon);
    if (options.plan) {
        if (options.output.file != "-") throw failure(ExitCode::Usage, "--plan writes no file: leave -o out");
        print_plan(loaded, options);
        return ExitCode::Success;
    }
    check_format(options, format, loaded);
    const RefinementSize size = planned(loaded.curve, options);
    const PictureAxes axes = chosen_axes(options.axes, loaded.space_dimension());
    Output output(options.output.file);
    if (context.verbose) say(context, fmt::format("{} points from {}\n", size.points, loaded.curve.size()));
    const int steps = static_cast<int>(options.steps);
    const ApplyOptions apply{context.threads, context.isa};
    if (format != "svg" && !options.limit) {
        write_polygon(output.sink(), format, refine(loaded.curve, steps, apply), loaded, context);
        output.commit();
        return ExitCode::Success;
    }
    // The curve itself, by the states of its cells.
    Refinement refinement(loaded.curve);
    refinement.advance(steps, apply);
    if (format == "svg")
        output.sink().write(curve_picture(planar_curve(loaded.curve, refinement, axes, loaded.coordinates),
                                          {picture_title(options, loaded), generator(context)}));
    else if (options.derivatives)
        write_limit_frames(output.sink(), format, refinement, column_names(loaded));
    else
        write_limit(output.sink(), format, refinement, loaded.coordinates, column_names(loaded));
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
