// SPDX-License-Identifier: MIT

#include "cli/intervals/polygon.h"

#include "cli/shell/load.h"
#include "cli/shell/settled.h"
#include "internode/input/polygon_file.h"

#include <fmt/format.h>

namespace internode::cli {

namespace {

InputPolygon weighted(InputPolygon polygon, const PolygonOptions& options) {
    if (!options.rational) return polygon;
    Settled<InputPolygon> made = with_weights(polygon);
    if (!made.value) throw failure(placed(std::move(made.refusal), polygon));
    return *std::move(made.value);
}

} // namespace

InputPolygon load_polygon(const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    return weighted(value_of(polygon_of_file(input.text, input.source, options.element, options.threads)), options);
}

std::vector<InputPolygon> load_polygons(const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    std::vector<InputPolygon> polygons =
        value_of(polygons_of_file(input.text, input.source, options.element, options.threads));
    for (InputPolygon& polygon : polygons) polygon = weighted(std::move(polygon), options);
    return polygons;
}

void refuse_repeated_point(const InputPolygon& polygon) {
    internode::Refusal refusal = repeated_point(polygon);
    if (!refusal.errors.empty()) throw failure(placed(std::move(refusal), polygon));
}

CurveOptions curve_options(const PolygonOptions& options) {
    return {options.degree, options.word, options.repeat, options.ends, options.rational};
}

std::vector<SettledCurve> load_curves(const IntervalSystem& system, const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    std::vector<SettledCurve> curves;
    for (const InputPolygon& polygon :
         value_of(polygons_of_file(input.text, input.source, options.element, options.threads))) {
        Settled<SettledCurve> curve = settle_curve(system, polygon, curve_options(options));
        if (!curve.value) throw failure(placed(std::move(curve.refusal), polygon));
        curves.push_back(*std::move(curve.value));
    }
    return curves;
}

SettledCurve load_polynomial_curve(const IntervalSystem& system, const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    SettledCurve loaded = value_of(
        settle_curve(system, value_of(polygon_of_file(input.text, input.source, options.element, options.threads)),
                     curve_options(options)));
    if (loaded.coordinates == Coordinates::Homogeneous)
        throw failure(ExitCode::Refused, fmt::format("the points of {} have weights: this command measures polynomial "
                                                     "curves",
                                                     loaded.source));
    return loaded;
}

} // namespace internode::cli
