// SPDX-License-Identifier: MIT

#include "internode/report/pyramid_report.h"

#include <cassert>
#include <utility>

namespace internode {

PyramidReport pyramid_report(Analysis analysis, Pyramid kept, const Fitting& fitting, const std::string& source) {
    assert(!analysis.polygons.empty() && kept.levels.size() == analysis.pyramid.levels.size());
    const std::size_t dimension = kept.coarse.dimension();
    std::vector<PolygonError> approximations = approximation_errors(analysis);
    std::vector<PolygonError> round_trips;
    const std::vector<std::vector<double>> whole = synthesise(analysis.pyramid);
    for (std::size_t level = 0; level < whole.size(); ++level)
        round_trips.push_back(polygon_error(whole[level], analysis.polygons[level], dimension));
    const bool thresholded = detail_count(kept) < detail_count(analysis.pyramid);
    const PolygonError kept_error =
        thresholded ? polygon_error(synthesise(kept).back(), analysis.polygons.back(), dimension) : round_trips.back();
    return {source,
            fitting,
            std::move(analysis),
            std::move(kept),
            thresholded,
            std::move(approximations),
            std::move(round_trips),
            kept_error};
}

} // namespace internode
