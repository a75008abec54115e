// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_fault.h"

#include "internode/mesh/face_sides.h"

#include <algorithm>

namespace internode {
namespace {

/// "3 7".
template<typename Numbers>
std::string listed(const Numbers& numbers, std::size_t base, const char* between) {
    std::string text;
    for (const auto number : numbers) text += (text.empty() ? "" : between) + std::to_string(number + base);
    return text;
}

class FaultFinder {
public:
    FaultFinder(std::size_t vertex_count, const FaceList& faces)
        : vertex_count_(vertex_count)
        , faces_(faces) {}

    [[nodiscard]] std::vector<MeshFault> find() && {
        if (faces_.corners().size() > most_half_edges || vertex_count_ > most_half_edges)
            return {{MeshFaultKind::TooLarge, {}, {}}};
        left_out_.assign(faces_.size(), false);
        has_fault_.assign(vertex_count_, false);
        find_bad_corners();
        find_duplicate_faces();
        find_bad_edges();
        find_bad_vertices();
        std::ranges::stable_sort(faults_, {}, &MeshFault::kind);
        return std::move(faults_);
    }

private:
    void find_bad_corners() {
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            for (const std::uint32_t corner : faces_[face])
                if (corner >= vertex_count_) leave_out(face, {MeshFaultKind::IndexOutOfRange, {corner}, {face}});
            std::vector<std::uint32_t> corners(faces_[face].begin(), faces_[face].end());
            std::ranges::sort(corners);
            if (corners.size() < 3 || std::ranges::adjacent_find(corners) != corners.end())
                leave_out(face, {MeshFaultKind::DegenerateFace, {faces_[face].begin(), faces_[face].end()}, {face}});
        }
    }

    void find_duplicate_faces() {
        for (FaceCopies& copies : copies_of_faces(faces_, left_out_)) {
            for (const std::size_t face : std::span(copies.faces).subspan(1)) left_out_[face] = true;
            add({MeshFaultKind::DuplicateFace, std::move(copies.corners), std::move(copies.faces)});
        }
    }

    void find_bad_edges() {
        sides_ = sides_by_edge(faces_, left_out_);
        for_each_edge(sides_, [this](std::span<const FaceSide> sides) {
            const bool same_way = sides.size() == 2 && sides[0].from == sides[1].from;
            if (sides.size() < 2 || (sides.size() == 2 && !same_way)) return;
            const auto [a, b] = sides.front().edge();
            MeshFault fault{same_way ? MeshFaultKind::Orientation : MeshFaultKind::NonManifoldEdge, {a, b}, {}};
            for (const FaceSide& side : sides) fault.faces.push_back(side.face);
            add(std::move(fault));
        });
    }

    /// The faces at a vertex are one fan, unless they follow one another but for some.
    void find_bad_vertices() {
        JoinedFaces joined(faces_);
        std::vector<std::size_t> count(vertex_count_); // faces at each
        std::vector<std::uint32_t> some(vertex_count_, no_side);
        for_each_edge(sides_, [&](std::span<const FaceSide> sides) {
            if (sides.size() == 2) joined.join(sides[0].side, sides[1].side);
            for (const FaceSide& side : sides) {
                ++count[side.from];
                some[side.from] = side.side;
            }
        });
        std::vector<bool> is_split(vertex_count_);
        for (std::size_t vertex = 0; vertex < vertex_count_; ++vertex)
            is_split[vertex] =
                count[vertex] > 0 && !has_fault_[vertex] && joined.fan_size(some[vertex]) < count[vertex];
        add_split_vertices(is_split);
        add_isolated_vertices();
    }

    void add_split_vertices(const std::vector<bool>& is_split) {
        if (std::ranges::find(is_split, true) == is_split.end()) return;
        std::vector<std::vector<std::size_t>> faces_at(vertex_count_);
        for (std::size_t face = 0; face < faces_.size(); ++face)
            for (const std::uint32_t corner : faces_[face])
                if (!left_out_[face] && is_split[corner]) faces_at[corner].push_back(face);
        for (std::size_t vertex = 0; vertex < vertex_count_; ++vertex)
            if (is_split[vertex])
                faults_.push_back({MeshFaultKind::NonManifoldVertex,
                                   {static_cast<std::uint32_t>(vertex)},
                                   std::move(faces_at[vertex])});
    }

    void add_isolated_vertices() {
        std::vector<bool> is_used(vertex_count_);
        for (const std::uint32_t corner : faces_.corners())
            if (corner < vertex_count_) is_used[corner] = true;
        for (std::size_t vertex = 0; vertex < vertex_count_; ++vertex)
            if (!is_used[vertex])
                faults_.push_back({MeshFaultKind::IsolatedVertex, {static_cast<std::uint32_t>(vertex)}, {}});
    }

    /// A fault that makes a face useless, and says nothing about its other corners.
    void leave_out(std::size_t face, MeshFault fault) {
        left_out_[face] = true;
        for (const std::uint32_t corner : faces_[face])
            if (corner < vertex_count_) has_fault_[corner] = true;
        faults_.push_back(std::move(fault));
    }

    void add(MeshFault fault) {
        for (const std::uint32_t vertex : fault.vertices) has_fault_[vertex] = true;
        faults_.push_back(std::move(fault));
    }

    std::size_t vertex_count_;
    const FaceList& faces_;
    std::vector<bool> left_out_;  ///< faces that count for no edge
    std::vector<bool> has_fault_; ///< vertices whose fans say nothing
    std::vector<FaceSide> sides_;
    std::vector<MeshFault> faults_;
};

} // namespace

std::string_view name_of(MeshFaultKind kind) {
    switch (kind) {
    case MeshFaultKind::TooLarge:
        return "too large";
    case MeshFaultKind::IndexOutOfRange:
        return "index out of range";
    case MeshFaultKind::DegenerateFace:
        return "degenerate face";
    case MeshFaultKind::DuplicateFace:
        return "duplicate face";
    case MeshFaultKind::Orientation:
        return "orientation";
    case MeshFaultKind::NonManifoldEdge:
        return "non-manifold edge";
    case MeshFaultKind::NonManifoldVertex:
        return "non-manifold vertex";
    case MeshFaultKind::IsolatedVertex:
        break;
    }
    return "isolated vertex";
}

std::string description(const MeshFault& fault, std::size_t base) {
    const std::string vertices = listed(fault.vertices, base, " ");
    const std::string faces = listed(fault.faces, base, ", ");
    switch (fault.kind) {
    case MeshFaultKind::TooLarge:
        return "more than " + std::to_string(most_half_edges) + " vertices or corners of faces, the limit";
    case MeshFaultKind::IndexOutOfRange:
        return "face " + faces + " has a corner " + vertices + ", and no vertex has that number";
    case MeshFaultKind::DegenerateFace:
        return "face " + faces +
               (fault.vertices.size() < 3 ? " has fewer than three corners: " : " has a corner twice: ") + vertices;
    case MeshFaultKind::DuplicateFace:
        return "faces " + faces + " have the same corners " + vertices;
    case MeshFaultKind::Orientation:
        return "faces " + faces + " pass the edge " + vertices + " in the same direction";
    case MeshFaultKind::NonManifoldEdge:
        return "the edge " + vertices + " has " + std::to_string(fault.faces.size()) + " faces: " + faces;
    case MeshFaultKind::NonManifoldVertex:
        return "the faces at vertex " + vertices + " are more than one fan: " + faces;
    case MeshFaultKind::IsolatedVertex:
        break;
    }
    return "vertex " + vertices + " has no face";
}

std::vector<MeshFault> mesh_faults(std::size_t vertex_count, const FaceList& faces) {
    return FaultFinder(vertex_count, faces).find();
}

} // namespace internode
