// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/pyramid_errors.h"

#include "internode/curve/reverse/hierarchy.h"
#include "internode/stencil/parallel.h"

#include <cassert>

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

PyramidErrors pyramid_errors(const Analysis& analysis, const Pyramid& kept, int threads) {
    assert(!analysis.polygons.empty() && kept.levels.size() == analysis.pyramid.levels.size());
    const std::size_t dimension = kept.coarse.dimension();
    const bool all_kept = detail_count(kept) == detail_count(analysis.pyramid);
    PyramidErrors errors;
    const auto measure_round_trips = [&] {
        const std::vector<std::vector<double>> whole = synthesise(analysis.pyramid);
        for (std::size_t level = 0; level < whole.size(); ++level)
            errors.round_trips.push_back(polygon_error(whole[level], analysis.polygons[level], dimension));
    };
    const auto measure_kept = [&] {
        if (!all_kept) errors.kept = polygon_error(synthesise(kept).back(), analysis.polygons.back(), dimension);
    };
    for_each_task(3, threads, [&](std::size_t task) {
        if (task == 0) return measure_round_trips();
        if (task == 1) return measure_kept();
        errors.approximations = approximation_errors(analysis);
    });
    if (all_kept) errors.kept = errors.round_trips.back();
    return errors;
}

} // namespace internode
