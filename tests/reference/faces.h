// SPDX-License-Identifier: MIT
//
// What keeps faces from being a mesh, by the definitions: each looked up among all faces.

#pragma once

#include "internode/mesh/mesh_fault.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace internode::reference {

using FaceCorners = std::vector<std::uint32_t>;

/// All faces of three and four different corners below `vertices`, each from its smallest corner on, in both
/// directions.
inline std::vector<FaceCorners> small_faces(std::uint32_t vertices) {
    std::vector<FaceCorners> all;
    const auto add = [&all](const FaceCorners& face) {
        std::set<std::uint32_t> different(face.begin(), face.end());
        if (different.size() == face.size() && *different.begin() == face.front()) all.push_back(face);
    };
    for (std::uint32_t a = 0; a < vertices; ++a)
        for (std::uint32_t b = 0; b < vertices; ++b)
            for (std::uint32_t c = 0; c < vertices; ++c) {
                add({a, b, c});
                for (std::uint32_t d = 0; d < vertices; ++d) add({a, b, c, d});
            }
    return all;
}

/// How many faces pass from one corner to the other.
inline int passages(const std::vector<FaceCorners>& faces, std::uint32_t from, std::uint32_t to) {
    int count = 0;
    for (const FaceCorners& face : faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            count += face[i] == from && face[(i + 1) % face.size()] == to ? 1 : 0;
    return count;
}

/// The faces at a vertex, hung together by edges at it, are one piece.
inline bool is_one_fan(const std::vector<FaceCorners>& faces, std::uint32_t vertex) {
    std::vector<std::set<std::uint32_t>> pieces; // by the two neighbours that each face has at the vertex
    for (const FaceCorners& face : faces) {
        const auto found = std::ranges::find(face, vertex);
        if (found == face.end()) continue;
        const auto at = static_cast<std::size_t>(found - face.begin());
        std::set<std::uint32_t> piece{face[(at + 1) % face.size()], face[(at + face.size() - 1) % face.size()]};
        std::vector<std::set<std::uint32_t>> apart;
        for (const std::set<std::uint32_t>& other : pieces) {
            const bool meets = std::ranges::any_of(other, [&](std::uint32_t v) { return piece.contains(v); });
            if (meets)
                piece.insert(other.begin(), other.end());
            else
                apart.push_back(other);
        }
        apart.push_back(piece);
        pieces = apart;
    }
    return pieces.size() <= 1;
}

/// Of faces with different corners below `vertices`; copies of a face count once.
inline std::set<MeshFaultKind> fault_kinds(std::uint32_t vertices, const std::vector<FaceCorners>& all) {
    std::set<MeshFaultKind> kinds;
    std::set<std::set<std::uint32_t>> known;
    std::vector<FaceCorners> faces;
    for (const FaceCorners& face : all) {
        if (known.insert({face.begin(), face.end()}).second)
            faces.push_back(face);
        else
            kinds.insert(MeshFaultKind::DuplicateFace);
    }
    for (std::uint32_t a = 0; a < vertices; ++a) {
        for (std::uint32_t b = 0; b < a; ++b) {
            const int there = passages(faces, a, b);
            const int back = passages(faces, b, a);
            if (there + back > 2) kinds.insert(MeshFaultKind::NonManifoldEdge);
            if (there + back == 2 && there != back) kinds.insert(MeshFaultKind::Orientation);
        }
        if (!is_one_fan(faces, a)) kinds.insert(MeshFaultKind::NonManifoldVertex);
        const bool used = std::ranges::any_of(
            faces, [a](const FaceCorners& face) { return std::ranges::find(face, a) != face.end(); });
        if (!used) kinds.insert(MeshFaultKind::IsolatedVertex);
    }
    return kinds;
}

} // namespace internode::reference
