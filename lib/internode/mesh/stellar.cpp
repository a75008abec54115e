// SPDX-License-Identifier: MIT
//
// The stellar operators. A letter is a vertex, `ab` the half-edge from a to b. What moves is moved with all who know
// it; faces, edges and vertices go from the largest number down, so that none that is to go has moved.

#include "internode/mesh/triangle_mesh.h"

#include <algorithm>

namespace internode {

std::string_view description(StellarRefusal refusal) {
    switch (refusal) {
    case StellarRefusal::None:
        return "nothing is in the way";
    case StellarRefusal::Boundary:
        return "the edge has one face only";
    case StellarRefusal::DoubledEdge:
        return "there is such an edge already";
    case StellarRefusal::DoubledFace:
        return "there is such a face already";
    case StellarRefusal::Valence:
        return "the vertex has not as many edges as a split gives it";
    case StellarRefusal::NotIncident:
        return "the edge does not end at the vertex";
    case StellarRefusal::Across:
        return "the vertex is on a boundary and the edge is not";
    }
    return {};
}

EdgeSplit TriangleMesh::split(Edge e) {
    const HalfEdge ab = half_edge(e);
    const HalfEdge ba = twin(ab);
    const HalfEdge bc = next(ab);
    const Vertex b = target(ab);
    const Vertex c = target(bc);
    const Side side_bc = side(bc);
    const Vertex m = add_vertex();
    // Of (a b c) remains (a m c); (m b c) is new.
    const HalfEdge mb = half_edge(add_face(m, b, c));
    const HalfEdge cm = previous(mb);
    const Edge half = add_edge();
    const Edge spoke_c = add_edge();
    move_half_edge(bc, next(mb), side_bc, b);
    origin_[to_index(bc)] = m;
    join(bc, cm, spoke_c);
    outgoing_[to_index(m)] = mb;
    if (ba == no_half_edge) {
        join(mb, no_half_edge, half);
        return {m, {e, half}, {spoke_c, spoke_c}};
    }
    // Of (b a d) remains (m a d); (b m d) is new.
    const HalfEdge db = previous(ba);
    const Vertex d = origin(db);
    const Side side_db = side(db);
    const HalfEdge bm = half_edge(add_face(b, m, d));
    const HalfEdge md = next(bm);
    const Edge spoke_d = add_edge();
    move_half_edge(db, previous(bm), side_db, d);
    replace_outgoing(ba, bm, b);
    origin_[to_index(ba)] = m;
    join(md, db, spoke_d);
    join(mb, bm, half);
    return {m, {e, half}, {spoke_c, spoke_d}};
}

FaceSplit TriangleMesh::split(Face f) {
    const auto [a, b, c] = corners(f);
    const HalfEdge ab = half_edge(f);
    const HalfEdge bc = next(ab);
    const HalfEdge ca = previous(ab);
    const Side side_bc = side(bc);
    const Side side_ca = side(ca);
    const Vertex m = add_vertex();
    // Of (a b c) remains (a b m); (b c m) and (c a m) are new.
    const HalfEdge new_bc = half_edge(add_face(b, c, m));
    const HalfEdge new_ca = half_edge(add_face(c, a, m));
    const std::array<Edge, 3> spokes{add_edge(), add_edge(), add_edge()};
    move_half_edge(bc, new_bc, side_bc, b);
    move_half_edge(ca, new_ca, side_ca, c);
    origin_[to_index(ca)] = m;
    join(ca, next(new_ca), spokes[0]);
    join(previous(new_bc), bc, spokes[1]);
    join(previous(new_ca), next(new_bc), spokes[2]);
    outgoing_[to_index(m)] = ca;
    return {m, spokes};
}

StellarRefusal TriangleMesh::weld(Vertex m, Edge kept) {
    const HalfEdge half = half_edge(kept);
    if (origin(half) != m && target(half) != m) return StellarRefusal::NotIncident;
    const HalfEdge ma = origin(half) == m ? half : twin(half);
    const HalfEdge am = origin(half) == m ? twin(half) : half;
    if (is_boundary(m) && ma != no_half_edge && am != no_half_edge) return StellarRefusal::Across;
    if (valence(m) != (is_boundary(m) ? 3U : 4U)) return StellarRefusal::Valence;
    // Beside m a on its left (m a x) and (m x b), on its right (m y a) and (m b y); at a boundary one of the sides.
    const HalfEdge xm = ma == no_half_edge ? no_half_edge : previous(ma);
    const HalfEdge my = am == no_half_edge ? no_half_edge : next(am);
    const HalfEdge mx = xm == no_half_edge ? no_half_edge : twin(xm);
    const HalfEdge ym = my == no_half_edge ? no_half_edge : twin(my);
    const Vertex a = ma == no_half_edge ? origin(am) : target(ma);
    const Vertex b = origin(previous(mx == no_half_edge ? ym : mx));
    // Where x or y has three edges only, a and b are joined already: no vertex is left with too few.
    if (edge_between(a, b)) return StellarRefusal::DoubledEdge;

    std::vector<Face> faces;
    std::vector<Edge> edges{edge(mx == no_half_edge ? next(ym) : previous(mx))};
    if (xm != no_half_edge) {
        faces.push_back(face(mx));
        edges.push_back(edge(xm));
        const HalfEdge xb = next(mx);
        const HalfEdge bm = previous(mx);
        origin_[to_index(ma)] = b;
        replace_outgoing(bm, ma, b);
        move_half_edge(xb, xm, side(xb), origin(xb));
    }
    if (my != no_half_edge) {
        faces.push_back(face(ym));
        edges.push_back(edge(my));
        const HalfEdge by = previous(ym);
        replace_outgoing(ym, next(my), origin(ym));
        origin_[to_index(my)] = b;
        move_half_edge(by, my, side(by), b);
    }
    remove(std::move(faces), std::move(edges), m);
    return StellarRefusal::None;
}

StellarRefusal TriangleMesh::weld(Vertex m) {
    if (is_boundary(m)) return StellarRefusal::Boundary;
    if (valence(m) != 3) return StellarRefusal::Valence;
    // The face of the smallest number stays: (a b m), to which (b c m) and (c a m) come.
    HalfEdge ma = half_edge(m);
    for (HalfEdge h = twin(previous(ma)); h != half_edge(m); h = twin(previous(h))) ma = std::min(ma, h);
    const HalfEdge ab = next(ma);
    const HalfEdge bm = previous(ma);
    const HalfEdge mb = twin(bm);
    const HalfEdge am = twin(ma);
    const HalfEdge bc = next(mb);
    const HalfEdge cm = previous(mb);
    const HalfEdge ca = previous(am);
    const Vertex c = origin(cm);
    const HalfEdge ba = twin(ab);
    if (ba != no_half_edge && origin(previous(ba)) == c) return StellarRefusal::DoubledFace;

    std::vector<Face> faces{face(mb), face(am)};
    std::vector<Edge> edges{edge(ma), edge(bm), edge(cm)};
    replace_outgoing(am, ab, origin(am));
    replace_outgoing(cm, ma, c);
    move_half_edge(bc, bm, side(bc), origin(bc));
    origin_[to_index(ma)] = c;
    move_half_edge(ca, ma, side(ca), c);
    remove(std::move(faces), std::move(edges), m);
    return StellarRefusal::None;
}

void TriangleMesh::remove(std::vector<Face> faces, std::vector<Edge> edges, Vertex v) {
    std::ranges::sort(faces, std::ranges::greater());
    std::ranges::sort(edges, std::ranges::greater());
    for (const Face f : faces) remove_face(f);
    for (const Edge e : edges) remove_edge(e);
    remove_vertex(v);
}

StellarRefusal TriangleMesh::flip_problem(Edge e) const {
    const HalfEdge ab = half_edge(e);
    const HalfEdge ba = twin(ab);
    if (ba == no_half_edge) return StellarRefusal::Boundary;
    if (edge_between(origin(previous(ab)), origin(previous(ba)))) return StellarRefusal::DoubledEdge;
    return StellarRefusal::None;
}

StellarRefusal TriangleMesh::flip(Edge e) {
    const StellarRefusal problem = flip_problem(e);
    if (problem == StellarRefusal::None) turn(e, Turn::Counterclockwise);
    return problem;
}

StellarRefusal TriangleMesh::unflip(Edge e) {
    const StellarRefusal problem = flip_problem(e);
    if (problem == StellarRefusal::None) turn(e, Turn::Clockwise);
    return problem;
}

/// (a b c) and (b a d) become (d c a) and (c d b), or the other way round (c d b) and (d c a).
void TriangleMesh::turn(Edge e, Turn turn) {
    const HalfEdge ab = half_edge(e);
    const HalfEdge ba = twin(ab);
    // Each half-edge of the quadrilateral, at its place.
    const HalfEdge bc = next(ab);
    const HalfEdge ca = previous(ab);
    const HalfEdge ad = next(ba);
    const HalfEdge db = previous(ba);
    const Vertex a = origin(ab);
    const Vertex b = origin(ba);
    const Vertex c = origin(ca);
    const Vertex d = origin(db);
    const Side side_bc = side(bc);
    const Side side_ca = side(ca);
    const Side side_ad = side(ad);
    const Side side_db = side(db);
    const auto put = [this](HalfEdge place, HalfEdge from, Side side, Vertex v) {
        origin_[to_index(place)] = v;
        move_half_edge(from, place, side, v);
    };
    const bool counterclockwise = turn == Turn::Counterclockwise;
    replace_outgoing(ab, counterclockwise ? ca : db, a);
    replace_outgoing(ba, counterclockwise ? db : ca, b);
    origin_[to_index(ab)] = counterclockwise ? d : c;
    origin_[to_index(ba)] = counterclockwise ? c : d;
    put(counterclockwise ? bc : ad, ca, side_ca, c);
    put(counterclockwise ? ca : db, ad, side_ad, a);
    put(counterclockwise ? ad : bc, db, side_db, d);
    put(counterclockwise ? db : ca, bc, side_bc, b);
}

} // namespace internode
