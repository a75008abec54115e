// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/pyramid_errors.h"

#include "internode/curve/reverse/hierarchy.h"

#include <cassert>
#include <utility>

namespace internode {

std::vector<PolygonError> approximation_errors(const Analysis& analysis) {
    const auto levels = static_cast<int>(analysis.pyramid.levels.size());
    const std::size_t dimension = analysis.pyramid.coarse.dimension();
    const Hierarchy hierarchy(analysis.pyramid.coarse.knots(), levels);
    std::vector<std::vector<double>> refined; // of the levels so far, all brought up to the same one
    for (int level = 0; level <= levels; ++level) {
        refined.push_back(analysis.polygons[static_cast<std::size_t>(level)]);
        if (level == levels) break;
        const GatherMatrix matrix = hierarchy.matrix(level);
        for (std::vector<double>& polygon : refined) polygon = product(matrix, polygon, dimension);
    }
    std::vector<PolygonError> errors;
    for (const std::vector<double>& polygon : refined)
        errors.push_back(polygon_error(polygon, analysis.polygons.back(), dimension));
    return errors;
}

PyramidErrors pyramid_errors(const Analysis& analysis, const Pyramid& kept) {
    assert(!analysis.polygons.empty() && kept.levels.size() == analysis.pyramid.levels.size());
    const std::size_t dimension = kept.coarse.dimension();
    std::vector<PolygonError> round_trips;
    const std::vector<std::vector<double>> whole = synthesise(analysis.pyramid);
    for (std::size_t level = 0; level < whole.size(); ++level)
        round_trips.push_back(polygon_error(whole[level], analysis.polygons[level], dimension));
    const bool all_kept = detail_count(kept) == detail_count(analysis.pyramid);
    const PolygonError error =
        all_kept ? round_trips.back() : polygon_error(synthesise(kept).back(), analysis.polygons.back(), dimension);
    return {approximation_errors(analysis), std::move(round_trips), error};
}

} // namespace internode
