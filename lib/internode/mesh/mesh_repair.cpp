// SPDX-License-Identifier: MIT
//
// Dropping comes first. Then faces are joined along edges of two, turned component by component, and the corners that
// joined faces share at a vertex are one vertex: a fan. Faces that were not joined at an edge may still share both its
// ends, by ways round these. No more than two do, for a face has but one other edge at an end; and as they close a fan
// that agrees in its direction, they pass the edge in both: what is made is a manifold.

#include "internode/mesh/mesh_repair.h"

#include "internode/mesh/face_sides.h"
#include "internode/mesh/mesh_fault.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

/// Sets of corners that are one vertex.
class CornerSets {
public:
    explicit CornerSets(std::size_t count)
        : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    [[nodiscard]] std::uint32_t find(std::uint32_t corner) {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t first = find(a);
        const std::uint32_t second = find(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<std::uint32_t> parent_;
};

class Repair {
public:
    Repair(std::size_t vertex_count, const FaceList& faces)
        : vertex_count_(vertex_count) {
        result_.vertices.resize(vertex_count);
        std::iota(result_.vertices.begin(), result_.vertices.end(), 0U);
        drop_bad_faces(faces);
        drop_duplicates();
    }

    RepairedMesh run() && {
        join_and_turn();
        split_vertices();
        drop_isolated();
        assert(mesh_faults(result_.vertices.size(), result_.faces).empty());
        return std::move(result_);
    }

private:
    void drop_bad_faces(const FaceList& faces) {
        for (std::size_t face = 0; face < faces.size(); ++face) {
            std::vector<std::uint32_t> corners(faces[face].begin(), faces[face].end());
            corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
            while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
            std::vector<std::uint32_t> sorted = corners;
            std::ranges::sort(sorted);
            const bool is_good = corners.size() >= 3 && sorted.back() < result_.vertices.size() &&
                                 std::ranges::adjacent_find(sorted) == sorted.end();
            if (!is_good) {
                ++result_.done.faces_dropped;
                continue;
            }
            result_.done.corners_dropped += faces[face].size() - corners.size();
            result_.faces.add(corners);
            result_.face_before.push_back(static_cast<std::uint32_t>(face));
        }
    }

    void drop_duplicates() {
        std::vector<bool> is_copy(result_.faces.size());
        for (const FaceCopies& copies : copies_of_faces(result_.faces, is_copy))
            for (const std::size_t face : std::span(copies.faces).subspan(1)) is_copy[face] = true;
        FaceList kept;
        std::vector<std::uint32_t> before;
        for (std::size_t face = 0; face < result_.faces.size(); ++face) {
            if (is_copy[face]) {
                ++result_.done.duplicates_dropped;
                continue;
            }
            kept.add(result_.faces[face]);
            before.push_back(result_.face_before[face]);
        }
        result_.faces = std::move(kept);
        result_.face_before = std::move(before);
    }

    /// Joins what agrees once turned, and turns it.
    void join_and_turn() {
        JoinedFaces pairs(result_.faces); // sides that meet, in whatever direction
        for_each_edge(sides_by_edge(result_.faces), [&](std::span<const FaceSide> sides) {
            if (sides.size() == 2) pairs.join(sides[0].side, sides[1].side);
            if (sides.size() > 2) ++result_.done.edges_cut;
        });
        std::vector<bool> is_seen(result_.faces.size());
        std::vector<bool> is_turned(result_.faces.size());
        for (std::size_t face = 0; face < result_.faces.size(); ++face)
            if (!is_seen[face]) turn_component(pairs, face, is_seen, is_turned);
        FaceList turned;
        for (std::size_t face = 0; face < result_.faces.size(); ++face) {
            std::vector<std::uint32_t> corners(result_.faces[face].begin(), result_.faces[face].end());
            if (is_turned[face]) std::reverse(corners.begin() + 1, corners.end());
            turned.add(corners);
        }
        result_.done.faces_turned += static_cast<std::size_t>(std::ranges::count(is_turned, true));
        result_.faces = std::move(turned);
    }

    void turn_component(const JoinedFaces& pairs, std::size_t start, std::vector<bool>& is_seen,
                        std::vector<bool>& is_turned) const {
        std::vector<std::size_t> component{start};
        is_seen[start] = true;
        for (std::size_t i = 0; i < component.size(); ++i) { // it grows
            const std::size_t face = component[i];
            for (std::size_t at = result_.faces.first(face); at < result_.faces.first(face + 1); ++at) {
                const auto side = static_cast<std::uint32_t>(at);
                const std::uint32_t twin = pairs.twin(side);
                if (twin == no_side || is_seen[pairs.face(twin)]) continue;
                const bool agrees = pairs.origin(side) != pairs.origin(twin);
                is_seen[pairs.face(twin)] = true;
                is_turned[pairs.face(twin)] = agrees == is_turned[face];
                component.push_back(pairs.face(twin));
            }
        }
        const auto turned = std::ranges::count_if(component, [&](std::size_t face) { return is_turned[face]; });
        if (2 * static_cast<std::size_t>(turned) > component.size())
            for (const std::size_t face : component) is_turned[face] = !is_turned[face];
    }

    /// One vertex for the corners that faces share which meet at an edge and agree there.
    void split_vertices() {
        const FaceList& faces = result_.faces;
        const JoinedFaces around(faces);
        CornerSets sets(faces.corners().size());
        for_each_edge(sides_by_edge(faces), [&](std::span<const FaceSide> sides) {
            if (sides.size() != 2) return;
            if (sides[0].from == sides[1].from) {
                ++result_.done.edges_cut;
                return;
            }
            sets.unite(sides[0].side, around.next(sides[1].side));
            sets.unite(around.next(sides[0].side), sides[1].side);
        });
        number_corners(sets);
    }

    /// The first set of a vertex keeps it; the others are new vertices.
    void number_corners(CornerSets& sets) {
        const std::span<const std::uint32_t> old = result_.faces.corners();
        std::vector<bool> is_taken(result_.vertices.size());
        std::vector<std::uint32_t> number(old.size(), no_side); // of each set
        std::vector<std::uint32_t> corners(old.size());
        for (std::uint32_t corner = 0; corner < old.size(); ++corner) {
            std::uint32_t& known = number[sets.find(corner)];
            if (known == no_side) known = is_taken[old[corner]] ? copy_of(old[corner]) : old[corner];
            is_taken[old[corner]] = true;
            corners[corner] = known;
        }
        set_corners(corners);
    }

    std::uint32_t copy_of(std::uint32_t vertex) {
        result_.vertices.push_back(result_.vertices[vertex]);
        return static_cast<std::uint32_t>(result_.vertices.size() - 1);
    }

    void set_corners(std::span<const std::uint32_t> corners) {
        FaceList faces;
        for (std::size_t face = 0; face < result_.faces.size(); ++face)
            faces.add(corners.subspan(result_.faces.first(face), result_.faces[face].size()));
        result_.faces = std::move(faces);
    }

    void drop_isolated() {
        std::vector<std::uint32_t> number(result_.vertices.size(), no_side);
        for (const std::uint32_t corner : result_.faces.corners()) number[corner] = 0;
        std::vector<std::uint32_t> kept;
        std::vector<bool> is_there(vertex_count_);
        for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
            if (number[vertex] == no_side) continue;
            number[vertex] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(result_.vertices[vertex]);
            is_there[kept.back()] = true;
        }
        std::vector<std::uint32_t> corners;
        corners.reserve(result_.faces.corners().size());
        for (const std::uint32_t corner : result_.faces.corners()) corners.push_back(number[corner]);
        set_corners(corners);
        const auto there = static_cast<std::size_t>(std::ranges::count(is_there, true));
        result_.done.vertices_dropped = vertex_count_ - there;
        result_.done.vertices_added = kept.size() - there;
        result_.vertices = std::move(kept);
    }

    std::size_t vertex_count_;
    RepairedMesh result_;
};

std::array<std::uint32_t, 2> ordered(std::array<std::uint32_t, 2> ends) {
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

} // namespace

RepairedMesh repaired(std::size_t vertex_count, const FaceList& faces) {
    if (vertex_count > most_half_edges || faces.corners().size() > most_half_edges)
        throw std::invalid_argument("a mesh has fewer than 2^31 vertices and corners");
    return Repair(vertex_count, faces).run();
}

RepairedPolygons repaired(const PolygonMesh& mesh) {
    RepairedMesh made = repaired(mesh.vertex_count(), mesh.faces);
    RepairedPolygons result{{{}, std::move(made.faces), {}, {}}, made.done};
    for (const std::uint32_t vertex : made.vertices) {
        const auto point = mesh.points.begin() + std::ptrdiff_t{3} * vertex;
        result.mesh.points.insert(result.mesh.points.end(), point, point + 3);
    }
    std::map<std::array<std::uint32_t, 2>, double> creases;
    for (const SharpEdge& crease : mesh.creases) creases[ordered(crease.ends)] = crease.sharpness;
    for_each_edge(sides_by_edge(result.mesh.faces), [&](std::span<const FaceSide> sides) {
        const auto [a, b] = sides.front().edge();
        const auto found = creases.find(ordered({made.vertices[a], made.vertices[b]}));
        if (found != creases.end()) result.mesh.creases.push_back({{a, b}, found->second});
    });
    std::map<std::uint32_t, double> corners;
    for (const SharpVertex& corner : mesh.corners) corners[corner.vertex] = corner.sharpness;
    for (std::uint32_t vertex = 0; vertex < made.vertices.size(); ++vertex)
        if (const auto found = corners.find(made.vertices[vertex]); found != corners.end())
            result.mesh.corners.push_back({vertex, found->second});
    return result;
}

} // namespace internode
