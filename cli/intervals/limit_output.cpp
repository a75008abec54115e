// SPDX-License-Identifier: MIT

#include "cli/intervals/limit_output.h"

#include "cli/requests/exit_code.h"
#include "internode/curve/limit.h"
#include "internode/io/csv.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace internode::cli {
namespace {

/// `count` rows that stand side by side in one table.
struct Columns {
    std::size_t width;
    std::span<const double> rows;
};

std::vector<double> side_by_side(std::size_t count, const std::vector<Columns>& parts) {
    std::vector<double> table;
    for (std::size_t i = 0; i < count; ++i) {
        for (const Columns& part : parts) {
            assert(part.rows.size() == count * part.width);
            const auto row = part.rows.subspan(i * part.width, part.width);
            table.insert(table.end(), row.begin(), row.end());
        }
    }
    return table;
}

std::vector<std::string> frame_names(const std::vector<std::string>& names) {
    std::vector<std::string> all{"t"};
    for (const char* prefix : {"", "d", "dd", "t"})
        for (const std::string& name : names) all.push_back(prefix + name);
    all.emplace_back("curvature");
    return all;
}

void refuse_what_doubles_cannot_hold(const LimitFrames& frames) {
    const auto finite = [](double x) { return std::isfinite(x); };
    const bool derivatives = std::ranges::all_of(frames.first, finite) && std::ranges::all_of(frames.second, finite);
    const bool curvatures = std::ranges::none_of(frames.curvatures, [](double x) { return std::isinf(x); });
    if (!derivatives || !curvatures)
        throw failure(ExitCode::Refused, "a derivative or a curvature is larger than every double",
                      "scale the lengths or the points");
}

} // namespace

void write_limit(Sink& sink, const std::string& format, const Refinement& refinement, Coordinates coordinates,
                 const std::vector<std::string>& names, int threads) {
    LimitPoints limit = limit_points(refinement);
    const bool is_rational = coordinates == Coordinates::Homogeneous;
    const std::size_t width = refinement.curve().dimension();
    const std::size_t dimension = is_rational ? width - 1 : width;
    if (is_rational) limit.points = projected_points(limit.points, width);
    const PointsView points{dimension, limit.points};
    assert(format == "csv" || format == "npy");
    if (format == "csv") {
        CsvOptions csv;
        csv.header = names;
        csv.header.insert(csv.header.begin(), "t");
        csv.parameter = limit.parameters;
        csv.threads = threads;
        write_csv(sink, points, csv);
    } else {
        const std::vector<double> rows =
            side_by_side(limit.parameters.size(), {{1, limit.parameters}, {dimension, limit.points}});
        write_npy(sink, {dimension + 1, rows});
    }
}

std::size_t write_limit_obj(Sink& sink, const Refinement& refinement, Coordinates coordinates, std::size_t before,
                            int threads) {
    LimitPoints limit = limit_points(refinement);
    const std::size_t width = refinement.curve().dimension();
    const bool is_rational = coordinates == Coordinates::Homogeneous;
    if (is_rational) limit.points = projected_points(limit.points, width);
    const PointsView points{is_rational ? width - 1 : width, limit.points};
    write_obj(sink, points, refinement.curve().ends(), {}, before, threads);
    return points.size();
}

void write_limit_frames(Sink& sink, const std::string& format, const Curve& given, const Refinement& refinement,
                        const std::vector<std::string>& names, int threads) {
    assert(format == "csv" || format == "npy");
    const LimitFrames frames = limit_frames(given, refinement);
    refuse_what_doubles_cannot_hold(frames);
    const std::size_t dimension = refinement.curve().dimension();
    const std::vector<double> table = side_by_side(frames.limit.parameters.size(), {{1, frames.limit.parameters},
                                                                                    {dimension, frames.limit.points},
                                                                                    {dimension, frames.first},
                                                                                    {dimension, frames.second},
                                                                                    {dimension, frames.tangents},
                                                                                    {1, frames.curvatures}});
    const PointsView rows{4 * dimension + 2, table};
    if (format == "npy")
        write_npy(sink, rows);
    else
        write_csv(sink, rows,
                  {.header = frame_names(names), .parameter = {}, .nan_is_missing = true, .threads = threads});
}

} // namespace internode::cli
