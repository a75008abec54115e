// SPDX-License-Identifier: MIT
//
// A mesh of triangles as index arrays: half-edge 3f + i goes from corner i of face f to corner i + 1, counterclockwise.
//
// Always a manifold, oriented, with or without boundary, without doubled edges or faces. The stellar operators
// (S2, section 5; Lickorish 1999) keep it one, or refuse with a reason and change nothing. An operator touches a
// neighbourhood; what it makes comes last in the arrays, and what it takes away is replaced by the last of its kind. So
// a split that is welded again leaves every array as it was. Levels are the caller's: new elements have level 0.

#pragma once

#include "internode/mesh/handles.h"
#include "internode/mesh/mesh_fault.h"

#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

/// Why an operator would not leave a mesh.
enum class StellarRefusal {
    None,
    Boundary,    ///< the edge has one face only
    DoubledEdge, ///< there is such an edge already
    DoubledFace, ///< there is such a face already
    Valence,     ///< the vertex has not as many edges as the split gave it
    NotIncident, ///< the edge does not end at the vertex
    Across,      ///< the vertex is on a boundary and the edge is not
};

/// A sentence without a full stop: "there is such an edge already".
[[nodiscard]] std::string_view description(StellarRefusal refusal);

/// What a split of an edge made.
struct EdgeSplit {
    Vertex vertex;              ///< on the edge
    std::array<Edge, 2> halves; ///< the first is the edge itself, now up to the vertex; its level is the old one's
    std::array<Edge, 2> spokes; ///< to the opposite corners; one and the same at a boundary
};

/// What a split of a face made.
struct FaceSplit {
    Vertex vertex;
    std::array<Edge, 3> spokes; ///< to the corners of the face, in their order
};

class TriangleMesh {
public:
    /// Of corners without faults (mesh_faults). \throw std::invalid_argument with the first fault
    TriangleMesh(std::size_t vertex_count, std::span<const std::uint32_t> corners);

    [[nodiscard]] std::size_t vertex_count() const { return outgoing_.size(); }
    [[nodiscard]] std::size_t edge_count() const { return of_edge_.size(); }
    [[nodiscard]] std::size_t face_count() const { return origin_.size() / 3; }

    // Around a face.
    [[nodiscard]] static Face face(HalfEdge h) { return handle_of<Face>(to_index(h) / 3); }
    [[nodiscard]] static HalfEdge next(HalfEdge h) {
        return handle_of<HalfEdge>(to_index(h) % 3 == 2 ? to_index(h) - 2 : to_index(h) + 1);
    }
    [[nodiscard]] static HalfEdge previous(HalfEdge h) {
        return handle_of<HalfEdge>(to_index(h) % 3 == 0 ? to_index(h) + 2 : to_index(h) - 1);
    }
    [[nodiscard]] static HalfEdge half_edge(Face f) { return handle_of<HalfEdge>(3 * to_index(f)); }
    /// The corners of a face, from that of half_edge(f) on.
    [[nodiscard]] std::array<Vertex, 3> corners(Face f) const {
        const HalfEdge h = half_edge(f);
        return {origin(h), origin(next(h)), origin(next(next(h)))};
    }

    [[nodiscard]] Vertex origin(HalfEdge h) const { return origin_[to_index(h)]; }
    [[nodiscard]] Vertex target(HalfEdge h) const { return origin(next(h)); }
    /// The other half of the edge, or no_half_edge.
    [[nodiscard]] HalfEdge twin(HalfEdge h) const { return twin_[to_index(h)]; }
    [[nodiscard]] Edge edge(HalfEdge h) const { return edge_of_[to_index(h)]; }
    /// One of an edge's half-edges.
    [[nodiscard]] HalfEdge half_edge(Edge e) const { return of_edge_[to_index(e)]; }
    /// One that leaves a vertex: at a boundary the one along it.
    [[nodiscard]] HalfEdge half_edge(Vertex v) const { return outgoing_[to_index(v)]; }

    [[nodiscard]] bool is_boundary(Edge e) const { return twin(half_edge(e)) == no_half_edge; }
    [[nodiscard]] bool is_boundary(Vertex v) const { return twin(half_edge(v)) == no_half_edge; }

    /// Calls visit(neighbour, edge) counterclockwise round a vertex, from half_edge(v) on; of a boundary vertex from
    /// one boundary edge to the other.
    template<typename Visit>
    void for_each_neighbour(Vertex v, Visit visit) const {
        const HalfEdge start = half_edge(v);
        HalfEdge h = start;
        do {
            visit(target(h), edge(h));
            const HalfEdge in = previous(h);
            h = twin(in);
            if (h == no_half_edge) visit(origin(in), edge(in));
        } while (h != no_half_edge && h != start);
    }
    /// Edges at a vertex.
    [[nodiscard]] std::size_t valence(Vertex v) const;
    [[nodiscard]] std::optional<Edge> edge_between(Vertex a, Vertex b) const;

    [[nodiscard]] int level(Vertex v) const { return vertex_level_[to_index(v)]; }
    [[nodiscard]] int level(Edge e) const { return edge_level_[to_index(e)]; }
    void set_level(Vertex v, int level) { vertex_level_[to_index(v)] = level; }
    void set_level(Edge e, int level) { edge_level_[to_index(e)] = level; }

    // The stellar operators. A weld takes the last vertex, edges and faces to the places of those that go; values that
    // a caller keeps beside the vertices move likewise.

    /// A vertex on an edge, joined to the corners opposite.
    EdgeSplit split(Edge e);
    /// A vertex in a face, joined to its corners.
    FaceSplit split(Face f);
    /// The inverse of the split of an edge: `kept` and the edge straight on become one, which is `kept` (though its
    /// handle may be another afterwards: the last edge moves). Refuses a vertex that has not four edges, or three at a
    /// boundary, and what would double an edge: so no vertex is left with too few.
    StellarRefusal weld(Vertex m, Edge kept);
    /// The inverse of the split of a face. Refuses a vertex at a boundary, or of another valence than 3, and what would
    /// double a face.
    StellarRefusal weld(Vertex m);
    /// Turns an edge counterclockwise to the other diagonal of its two triangles.
    StellarRefusal flip(Edge e);
    /// Turns it clockwise: the inverse of flip().
    StellarRefusal unflip(Edge e);

    /// Equal are meshes with the same faces, edges and levels; which half-edge stands for a vertex does not count.
    friend bool operator==(const TriangleMesh& a, const TriangleMesh& b) {
        return a.origin_ == b.origin_ && a.twin_ == b.twin_ && a.edge_of_ == b.edge_of_ && a.of_edge_ == b.of_edge_ &&
               a.vertex_level_ == b.vertex_level_ && a.edge_level_ == b.edge_level_;
    }

private:
    /// What a half-edge has beside its origin.
    struct Side {
        HalfEdge twin;
        Edge edge;
    };
    [[nodiscard]] Side side(HalfEdge h) const { return {twin(h), edge(h)}; }
    /// The half-edge from `v` that stood at `from` and had that side stands at `to` from now on; who knew it learns it.
    void move_half_edge(HalfEdge from, HalfEdge to, Side side, Vertex v);
    /// Two halves of an edge; b may be none.
    void join(HalfEdge a, HalfEdge b, Edge e);
    [[nodiscard]] Face add_face(Vertex a, Vertex b, Vertex c);
    [[nodiscard]] Edge add_edge();
    [[nodiscard]] Vertex add_vertex();
    void replace_outgoing(HalfEdge from, HalfEdge to, Vertex v) {
        if (half_edge(v) == from) outgoing_[to_index(v)] = to;
    }
    void remove_face(Face f);
    void remove_edge(Edge e);
    void remove_vertex(Vertex v);
    void remove(std::vector<Face> faces, std::vector<Edge> edges, Vertex v);
    enum class Turn { Counterclockwise, Clockwise };
    void turn(Edge e, Turn turn);
    [[nodiscard]] StellarRefusal flip_problem(Edge e) const;

    // Of half-edges.
    std::vector<Vertex> origin_;
    std::vector<HalfEdge> twin_;
    std::vector<Edge> edge_of_;
    // Of vertices.
    std::vector<HalfEdge> outgoing_;
    std::vector<int> vertex_level_;
    // Of edges.
    std::vector<HalfEdge> of_edge_;
    std::vector<int> edge_level_;
};

} // namespace internode
