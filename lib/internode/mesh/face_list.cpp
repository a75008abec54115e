// SPDX-License-Identifier: MIT

#include "internode/mesh/face_list.h"

#include <stdexcept>

namespace internode {

FaceList triangles(std::span<const std::uint32_t> corners) {
    if (corners.size() % 3 != 0) throw std::invalid_argument("corners of triangles come in threes");
    FaceList faces;
    for (std::size_t first = 0; first < corners.size(); first += 3) faces.add(corners.subspan(first, 3));
    return faces;
}

} // namespace internode
