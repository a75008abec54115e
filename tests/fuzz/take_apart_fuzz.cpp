// SPDX-License-Identifier: MIT
//
// Any bytes as a file of one polygon that is taken apart and put together again. It is refused with a sentence, or
// coarse polygon and details give as many points back, and its pyramid's JSON is read as the same pyramid.

#include "internode/input/polygon_file.h"
#include "internode/input/settled_contour.h"
#include "internode/input/settled_pyramid.h"
#include "internode/report/json/pyramid_json.h"
#include "internode/report/pyramid_report.h"
#include "tests/fuzz/small_inputs.h"

#include <stdexcept>

namespace {

using namespace internode;
using fuzz::require;

std::optional<Analysis> analysis_of(const SettledContour& contour) {
    try {
        return analyse(contour.coarse, contour.levels, contour.dimension, contour.points);
    } catch (const std::range_error&) { // coarse points beyond doubles: the command says so
        return std::nullopt;
    }
}

void require_whole(const SettledContour& contour) {
    std::optional<Analysis> analysis = analysis_of(contour);
    if (!analysis) return;
    Pyramid kept = analysis->pyramid;
    const std::vector<std::vector<double>> polygons = synthesise(kept);
    require(polygons.back().size() == contour.points.size());
    const PyramidReport report = pyramid_report(*std::move(analysis), std::move(kept), contour.fitting, "fuzz");
    const ParsedPyramid parsed = read_pyramid(pyramid_json(report, {"0", "fuzz"}), "again.json");
    require(parsed.pyramid.has_value());
    const Settled<Pyramid> again = settle_pyramid(*parsed.pyramid);
    require(again.value && again.value->coarse.points() == report.kept.coarse.points());
    require(again.value->coarse.knots().origin() == contour.coarse.origin());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Chosen chosen = fuzz::chosen(data, size);
    const Settled<InputPolygon> read = polygon_of_file(chosen.text, "fuzz.csv");
    require(read.value.has_value() == read.refusal.errors.empty());
    if (!read.value || !fuzz::is_small(*read.value)) return 0;
    ContourOptions options;
    options.curve = fuzz::options_of(chosen.choice);
    options.curve.rational = false;
    options.levels = 1 + chosen.choice % 2;
    options.fit = (chosen.choice & 4U) != 0 ? FitChoice::Cut : FitChoice::Refuse;
    options.unclamped = (chosen.choice & 128U) != 0;
    const Settled<SettledContour> contour = settle_contour(fuzz::system_of(chosen.choice), *read.value, options);
    require(contour.value.has_value() == contour.refusal.errors.empty());
    if (!contour.value)
        require(!to_string(contour.refusal.errors).empty());
    else if (contour.value->coarse.degree() <= 4)
        require_whole(*contour.value);
    return 0;
}
