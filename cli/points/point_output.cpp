// SPDX-License-Identifier: MIT

#include "cli/points/point_output.h"

#include "cli/shell/generator.h"
#include "cli/shell/parts.h"
#include "internode/io/csv.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/point/strands.h"
#include "internode/report/json/points_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode::cli {

namespace {

bool has_weights(const PointStrands& strands, const LoadedPoints& loaded) {
    return loaded.coordinates == Coordinates::Homogeneous && strands.dimension == loaded.system->dimension() &&
           strands.dimension > 1;
}

/// Rows divided by their last number, which stays.
std::vector<double> divided(const std::vector<double>& rows, std::size_t dimension) {
    assert(dimension > 1);
    for (std::size_t last = dimension - 1; last < rows.size(); last += dimension)
        if (!(rows[last] > 0))
            throw failure(ExitCode::Refused,
                          fmt::format("the weight of point {} has become {}", last / dimension + 1, rows[last]),
                          "homogeneous points need positive weights");
    std::vector<double> points = projected(rows, dimension);
    const auto lost = std::ranges::find_if_not(points, [](double x) { return std::isfinite(x); });
    if (lost != points.end())
        throw failure(ExitCode::Refused,
                      fmt::format("point {}, divided by its weight, is larger than every double",
                                  static_cast<std::size_t>(lost - points.begin()) / dimension + 1),
                      "scale the points or the weights");
    return points;
}

/// Without the last number of each row.
std::vector<double> without_weights(const std::vector<double>& rows, std::size_t dimension) {
    std::vector<double> points;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if ((i + 1) % dimension != 0) points.push_back(rows[i]);
    return points;
}

std::vector<std::string> column_names(const LoadedPoints& loaded, std::size_t dimension, bool weighted) {
    const std::size_t space = dimension - (weighted ? 1 : 0);
    std::vector<std::string> names = loaded.columns.size() == space ? loaded.columns : coordinate_names(space);
    if (weighted) names.emplace_back("w");
    return names;
}

/// The lines that a word has of its own are drawn instead of its strands.
std::vector<ObjPolyline> polylines_of(const PointStrands& strands, std::size_t points) {
    std::vector<ObjPolyline> polylines;
    for (std::size_t i = strands.size(); i + 1 < points; i += 2) polylines.push_back({{i, i + 1}, false});
    if (polylines.empty())
        for (const PointStrands::Strand& strand : strands.strands)
            polylines.push_back({strand.points, strand.closed && strand.points.size() > 1});
    return polylines;
}

/// The vertices of a part behind `before` of the parts before it; how many it has.
std::size_t write_point_obj(Sink& sink, const PointStrands& strands, std::size_t before, const Context& context) {
    std::vector<double> points = strands.points;
    points.insert(points.end(), strands.lines.begin(), strands.lines.end());
    const PointsView view{strands.dimension, points};
    std::vector<std::string> comments;
    if (before == 0) comments = {"internode " + generator(context).version, context.command_line};
    write_obj(sink, view, polylines_of(strands, view.size()), comments, before, context.apply.threads);
    return view.size();
}

void check_obj(const PointStrands& strands) {
    assert(strands.dimension > 0);
    if (strands.dimension > max_obj_dimension)
        throw failure(
            ExitCode::Refused,
            fmt::format("OBJ has at most {} coordinates, the points have {}", max_obj_dimension, strands.dimension),
            "use CSV, JSON or NPY");
}

void refuse_nothing(const PointStrands& strands, const LoadedPoints& loaded, const std::string& format) {
    const bool is_lost = loaded.part > 0 && format == "csv"; // a table without rows
    if (strands.size() > 0 || (!strands.lines.empty() && !is_lost)) return;
    const std::string part = loaded.part > 0 ? fmt::format(" of part {}", loaded.part) : "";
    throw failure(ExitCode::Refused, fmt::format("no module of the last word{} has exactly one point", part),
                  "--format text writes the word itself");
}

void write_csv_parts(Sink& sink, const std::vector<DrawnPart>& parts, const Context& context) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [loaded, strands, weighted] = parts[i];
        PartSink part(sink, i == 0, written_break(loaded->break_text, i == 0));
        write_csv(part, {strands.dimension, strands.points},
                  {.header = column_names(*loaded, strands.dimension, weighted), .threads = context.apply.threads});
    }
}

void write_json_parts(Sink& sink, const std::vector<DrawnPart>& parts, std::uint64_t cycles, const Context& context) {
    std::vector<PointsPart> documents;
    for (const auto& [loaded, strands, weighted] : parts)
        documents.push_back(
            {strands, *loaded->system, {loaded->name, cycles, weighted, generator(context), context.apply.threads}});
    if (documents.size() == 1)
        write_points_json(sink, parts.front().strands, *parts.front().loaded->system, documents.front().document);
    else
        write_parts_json(sink, documents);
}

} // namespace

void project(PointStrands& strands, const LoadedPoints& loaded) {
    if (!has_weights(strands, loaded)) return;
    strands.points = without_weights(divided(strands.points, strands.dimension), strands.dimension);
    strands.lines = without_weights(divided(strands.lines, strands.dimension), strands.dimension);
    --strands.dimension;
}

DrawnPart drawn_part(PointStrands strands, const LoadedPoints& loaded, const std::string& format) {
    refuse_nothing(strands, loaded, format);
    if (format == "obj") {
        project(strands, loaded);
        check_obj(strands);
        return {&loaded, std::move(strands), false};
    }
    const bool weighted = has_weights(strands, loaded);
    if (weighted) {
        strands.points = divided(strands.points, strands.dimension);
        strands.lines = divided(strands.lines, strands.dimension);
    }
    return {&loaded, std::move(strands), weighted};
}

void write_points(Sink& sink, const std::string& format, const std::vector<DrawnPart>& parts, std::uint64_t cycles,
                  const Context& context) {
    assert(!parts.empty());
    if (format == "csv") {
        for (const DrawnPart& part : parts)
            require_equal_columns(parts.front().strands.dimension, part.strands.dimension);
        write_csv_parts(sink, parts, context);
    } else if (format == "npy") {
        assert(parts.size() == 1);
        const PointStrands& only = parts.front().strands;
        write_npy(sink, {only.dimension, only.points});
    } else if (format == "obj") {
        std::size_t vertices = 0;
        for (const DrawnPart& part : parts) vertices += write_point_obj(sink, part.strands, vertices, context);
    } else {
        write_json_parts(sink, parts, cycles, context);
    }
}

} // namespace internode::cli
