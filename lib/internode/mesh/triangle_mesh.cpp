// SPDX-License-Identifier: MIT

#include "internode/mesh/triangle_mesh.h"

#include "internode/mesh/face_sides.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace internode {
namespace {

/// The half-edge that goes the other way, for each.
std::vector<HalfEdge> twins_of(const FaceList& faces) {
    const JoinedFaces joined = joined_faces(faces);
    std::vector<HalfEdge> twins;
    twins.reserve(joined.side_count());
    for (std::uint32_t side = 0; side < joined.side_count(); ++side)
        twins.push_back(joined.twin(side) == no_side ? no_half_edge : HalfEdge{joined.twin(side)});
    return twins;
}

} // namespace

TriangleMesh::TriangleMesh(std::size_t vertex_count, std::span<const std::uint32_t> corners) {
    const FaceList faces = triangles(corners);
    const std::vector<MeshFault> faults = mesh_faults(vertex_count, faces);
    if (!faults.empty()) throw std::invalid_argument(description(faults.front()));
    origin_.reserve(corners.size());
    for (const std::uint32_t corner : corners) origin_.push_back(Vertex{corner});
    twin_ = twins_of(faces);
    edge_of_.resize(corners.size());
    outgoing_.assign(vertex_count, no_half_edge);
    vertex_level_.assign(vertex_count, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto h = handle_of<HalfEdge>(i);
        if (twin(h) == no_half_edge || h < twin(h)) join(h, twin(h), add_edge());
        if (half_edge(origin(h)) == no_half_edge || twin(h) == no_half_edge) outgoing_[to_index(origin(h))] = h;
    }
}

std::size_t TriangleMesh::valence(Vertex v) const {
    std::size_t count = 0;
    for_each_neighbour(v, [&count](Vertex, Edge) { ++count; });
    return count;
}

std::optional<Edge> TriangleMesh::edge_between(Vertex a, Vertex b) const {
    std::optional<Edge> found;
    for_each_neighbour(a, [&](Vertex neighbour, Edge e) {
        if (neighbour == b) found = e;
    });
    return found;
}

void TriangleMesh::move_half_edge(HalfEdge from, HalfEdge to, Side side, Vertex v) {
    twin_[to_index(to)] = side.twin;
    edge_of_[to_index(to)] = side.edge;
    if (side.twin != no_half_edge) twin_[to_index(side.twin)] = to;
    if (half_edge(side.edge) == from) of_edge_[to_index(side.edge)] = to;
    replace_outgoing(from, to, v);
}

void TriangleMesh::join(HalfEdge a, HalfEdge b, Edge e) {
    twin_[to_index(a)] = b;
    edge_of_[to_index(a)] = e;
    of_edge_[to_index(e)] = a;
    if (b == no_half_edge) return;
    twin_[to_index(b)] = a;
    edge_of_[to_index(b)] = e;
}

Face TriangleMesh::add_face(Vertex a, Vertex b, Vertex c) {
    const auto added = handle_of<Face>(face_count());
    origin_.insert(origin_.end(), {a, b, c});
    twin_.insert(twin_.end(), 3, no_half_edge);
    edge_of_.insert(edge_of_.end(), 3, Edge{});
    return added;
}

Edge TriangleMesh::add_edge() {
    of_edge_.push_back(no_half_edge);
    edge_level_.push_back(0);
    return handle_of<Edge>(edge_count() - 1);
}

Vertex TriangleMesh::add_vertex() {
    outgoing_.push_back(no_half_edge);
    vertex_level_.push_back(0);
    return handle_of<Vertex>(vertex_count() - 1);
}

void TriangleMesh::remove_face(Face f) {
    const auto last = handle_of<Face>(face_count() - 1);
    if (f != last) {
        HalfEdge from = half_edge(last);
        HalfEdge to = half_edge(f);
        for (int corner = 0; corner < 3; ++corner, from = next(from), to = next(to)) {
            origin_[to_index(to)] = origin(from);
            move_half_edge(from, to, side(from), origin(from));
        }
    }
    origin_.resize(origin_.size() - 3);
    twin_.resize(origin_.size());
    edge_of_.resize(origin_.size());
}

void TriangleMesh::remove_edge(Edge e) {
    const auto last = handle_of<Edge>(edge_count() - 1);
    if (e != last) {
        const HalfEdge h = half_edge(last);
        join(h, twin(h), e);
        set_level(e, level(last));
    }
    of_edge_.pop_back();
    edge_level_.pop_back();
}

void TriangleMesh::remove_vertex(Vertex v) {
    const auto last = handle_of<Vertex>(vertex_count() - 1);
    if (v != last) {
        const HalfEdge start = half_edge(last);
        HalfEdge h = start;
        do {
            origin_[to_index(h)] = v;
            h = twin(previous(h));
        } while (h != no_half_edge && h != start);
        outgoing_[to_index(v)] = start;
        set_level(v, level(last));
    }
    outgoing_.pop_back();
    vertex_level_.pop_back();
}

} // namespace internode
