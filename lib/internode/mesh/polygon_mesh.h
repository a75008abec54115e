// SPDX-License-Identifier: MIT
//
// Points in space and the faces between them, whatever they are: faults and all.

#pragma once

#include "internode/mesh/face_list.h"

#include <array>
#include <cstdint>
#include <vector>

namespace internode {

/// An edge that subdivision is to keep sharp, for so many steps; 10 and more: for ever.
struct SharpEdge {
    std::array<std::uint32_t, 2> ends;
    double sharpness;
    friend bool operator==(const SharpEdge&, const SharpEdge&) = default;
};

struct SharpVertex {
    std::uint32_t vertex;
    double sharpness;
    friend bool operator==(const SharpVertex&, const SharpVertex&) = default;
};

struct PolygonMesh {
    std::vector<double> points; ///< x, y, z of each vertex
    FaceList faces;
    std::vector<SharpEdge> creases;
    std::vector<SharpVertex> corners;

    [[nodiscard]] std::size_t vertex_count() const { return points.size() / 3; }
};

} // namespace internode
