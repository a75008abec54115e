// SPDX-License-Identifier: MIT

#include "cli/points/point_output.h"

#include "cli/shell/generator.h"
#include "internode/io/csv.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/point/strands.h"
#include "internode/report/json/points_json.h"

#include <fmt/format.h>

#include <cassert>

namespace internode::cli {

namespace {

bool has_weights(const PointStrands& strands, const LoadedPoints& loaded) {
    return loaded.coordinates == Coordinates::Homogeneous && strands.dimension == loaded.system.dimension() &&
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
    return projected(rows, dimension);
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
void write_point_obj(Sink& sink, PointStrands strands, const LoadedPoints& loaded, const Context& context) {
    project(strands, loaded);
    assert(strands.dimension > 0);
    if (strands.dimension > max_obj_dimension)
        throw failure(
            ExitCode::Refused,
            fmt::format("OBJ has at most {} coordinates, the points have {}", max_obj_dimension, strands.dimension),
            "use CSV, JSON or NPY");
    std::vector<double> points = strands.points;
    points.insert(points.end(), strands.lines.begin(), strands.lines.end());
    std::vector<ObjPolyline> polylines;
    for (std::size_t i = strands.size(); i + 1 < points.size() / strands.dimension; i += 2)
        polylines.push_back({{i, i + 1}, false});
    if (polylines.empty())
        for (const PointStrands::Strand& strand : strands.strands)
            polylines.push_back({strand.points, strand.closed && strand.points.size() > 1});
    write_obj(sink, {strands.dimension, points}, polylines,
              std::vector<std::string>{"internode " + generator(context).version, context.command_line});
}

} // namespace

void project(PointStrands& strands, const LoadedPoints& loaded) {
    if (!has_weights(strands, loaded)) return;
    strands.points = without_weights(divided(strands.points, strands.dimension), strands.dimension);
    strands.lines = without_weights(divided(strands.lines, strands.dimension), strands.dimension);
    --strands.dimension;
}

void write_points(Sink& sink, const std::string& format, PointStrands strands, const LoadedPoints& loaded,
                  std::uint64_t cycles, const Context& context) {
    if (strands.size() == 0 && strands.lines.empty())
        throw failure(ExitCode::Refused, "no module of the last word has exactly one point",
                      "--format text writes the word itself");
    if (format == "obj") {
        write_point_obj(sink, std::move(strands), loaded, context);
        return;
    }
    const bool weighted = has_weights(strands, loaded);
    if (weighted) {
        strands.points = divided(strands.points, strands.dimension);
        strands.lines = divided(strands.lines, strands.dimension);
    }
    const PointsView points{strands.dimension, strands.points};
    if (format == "csv")
        write_csv(sink, points, {column_names(loaded, strands.dimension, weighted), {}});
    else if (format == "npy")
        write_npy(sink, points);
    else
        write_points_json(sink, strands, loaded.system, {loaded.name, cycles, weighted, generator(context)});
}

} // namespace internode::cli
