// SPDX-License-Identifier: MIT

#include "internode/mesh/face_sides.h"

#include <cassert>

namespace internode {

std::vector<FaceSide> sides_by_edge(const FaceList& faces, const std::vector<bool>& left_out) {
    assert(faces.corners().size() <= most_half_edges && (left_out.empty() || left_out.size() == faces.size()));
    std::vector<FaceSide> sides;
    sides.reserve(faces.corners().size());
    for (std::size_t face = 0; face < faces.size(); ++face) {
        if (!left_out.empty() && left_out[face]) continue;
        const std::span<const std::uint32_t> corners = faces[face];
        for (std::size_t i = 0; i < corners.size(); ++i)
            sides.push_back({corners[i], corners[(i + 1) % corners.size()],
                             static_cast<std::uint32_t>(faces.first(face) + i), static_cast<std::uint32_t>(face)});
    }
    std::ranges::sort(sides, [](const FaceSide& a, const FaceSide& b) {
        return a.edge() != b.edge() ? a.edge() < b.edge() : a.side < b.side;
    });
    return sides;
}

JoinedFaces::JoinedFaces(const FaceList& faces)
    : faces_(faces)
    , face_(faces.corners().size())
    , twin_(faces.corners().size(), no_side) {
    for (std::size_t face = 0; face < faces.size(); ++face)
        for (std::size_t side = faces.first(face); side < faces.first(face + 1); ++side)
            face_[side] = static_cast<std::uint32_t>(face);
}

std::size_t JoinedFaces::fan_size(std::uint32_t side) const {
    std::size_t size = 1;
    std::uint32_t at = twin(previous(side));
    for (; at != no_side && at != side; at = twin(previous(at))) ++size;
    if (at == side) return size;
    for (at = twin(side); at != no_side; at = twin(next(at))) ++size;
    return size;
}

JoinedFaces joined_faces(const FaceList& faces) {
    JoinedFaces joined(faces);
    for_each_edge(sides_by_edge(faces), [&joined](std::span<const FaceSide> sides) {
        assert(sides.size() <= 2);
        if (sides.size() == 2) joined.join(sides[0].side, sides[1].side);
    });
    return joined;
}

} // namespace internode
