// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/intervals/curve_output.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "cli/shell/settled.h"
#include "internode/curve/refinement.h"
#include "internode/input/settled_pyramid.h"
#include "internode/io/csv.h"
#include "internode/io/json/pyramid_json.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

Pyramid load_pyramid(const std::string& place) {
    const LoadedText input = load_text(place);
    const ParsedPyramid parsed = read_pyramid(input.text, input.source);
    if (!parsed.pyramid) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return value_of(settle_pyramid(*parsed.pyramid));
}

/// The pyramid up to a level.
Pyramid lower_part(Pyramid pyramid, const ComposeOptions& options) {
    const std::uint64_t level = options.level.value_or(pyramid.levels.size());
    if (level > pyramid.levels.size())
        throw failure(ExitCode::Usage,
                      fmt::format("--level {} of a pyramid whose finest level is {}", level, pyramid.levels.size()));
    pyramid.levels.resize(static_cast<std::size_t>(level));
    const std::uint64_t points = pyramid.levels.empty() ? pyramid.coarse.size() : pyramid.levels.back().points;
    if (points > options.max_points)
        throw failure(ExitCode::Refused, fmt::format("{} points are more than {}", points, options.max_points),
                      "a larger --max-points, or a lower --level");
    return pyramid;
}

void write_polygon(Sink& sink, const std::string& format, const Curve& curve, const Context& context) {
    const PointsView points{curve.dimension(), curve.points()};
    if (format == "csv") {
        CsvOptions csv;
        csv.header = coordinate_names(curve.dimension());
        csv.threads = context.apply.threads;
        write_csv(sink, points, csv);
    } else if (format == "npy") {
        write_npy(sink, points);
    } else if (format == "obj") {
        write_obj(sink, points, curve.ends(),
                  std::vector<std::string>{"internode " + generator(context).version, context.command_line}, 0,
                  context.apply.threads);
    } else {
        write_curve(sink, curve, context);
    }
}

} // namespace

ExitCode run(const ComposeOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"compose", {}, ""});
    const Pyramid pyramid = lower_part(load_pyramid(options.pyramid), options);
    if (format == "obj" && pyramid.coarse.dimension() > max_obj_dimension)
        throw failure(ExitCode::Refused, fmt::format("OBJ has at most {} coordinates, the points have {}",
                                                     max_obj_dimension, pyramid.coarse.dimension()));
    Output output(options.output.file);
    Knots knots = refined_knots(pyramid.coarse.knots(), static_cast<int>(pyramid.levels.size()));
    CheckedCurve curve = make_curve(std::move(knots), pyramid.coarse.dimension(), synthesise(pyramid).back());
    if (!curve.curve) throw failure(ExitCode::Refused, curve.problems.front());
    write_polygon(output.sink(), format, *curve.curve, context);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
