// SPDX-License-Identifier: MIT

#include "internode/io/points_view.h"

#include <stdexcept>

namespace internode {

void require_whole_rows(const PointsView& points) {
    if (points.dimension == 0 || points.coordinates.size() % points.dimension != 0)
        throw std::invalid_argument("coordinates that do not make whole points");
}

} // namespace internode
