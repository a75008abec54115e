// SPDX-License-Identifier: MIT

#include "internode/mesh/triangle_mesh.h"

#include "internode/mesh/mesh_facts.h"
#include "tests/fixtures/random_curve.h"
#include "tests/reference/triangles.h"

#include <gmock/gmock.h>

#include <map>

namespace internode {
namespace {

using reference::Corner;
using reference::Triangle;
using reference::Triangles;
using testing::ElementsAre;
using testing::Pair;

struct Shape {
    std::size_t vertices;
    std::vector<Corner> corners;
};

/// A grid of squares cut in two, rows and columns of vertices; each direction goes round or ends.
Shape squares(Corner rows, Corner columns, bool round_rows, bool round_columns) {
    Shape shape{std::size_t{rows} * columns, {}};
    const auto at = [&](Corner i, Corner j) { return i % rows * columns + j % columns; };
    for (Corner i = 0; i + (round_rows ? 0 : 1) < rows; ++i)
        for (Corner j = 0; j + (round_columns ? 0 : 1) < columns; ++j)
            for (const Corner corner :
                 {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
                shape.corners.push_back(corner);
    return shape;
}

const Shape triangle{3, {0, 1, 2}};
const Shape tetrahedron{4, {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}};
const Shape octahedron{6, {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};

const std::map<std::string, Shape>& shapes() {
    static const std::map<std::string, Shape> all{{"triangle", triangle},
                                                  {"tetrahedron", tetrahedron},
                                                  {"octahedron", octahedron},
                                                  {"two components", {6, {0, 1, 2, 3, 4, 5}}},
                                                  {"a vertex with a ring", {5, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}}},
                                                  {"strip", squares(2, 4, false, false)},
                                                  {"square", squares(4, 4, false, false)},
                                                  {"cylinder", squares(2, 3, false, true)},
                                                  {"torus", squares(3, 4, true, true)}};
    return all;
}

TriangleMesh mesh_of(const Shape& shape) {
    return TriangleMesh(shape.vertices, shape.corners);
}

MeshTopology topology_of(const TriangleMesh& mesh) {
    FaceList faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto [a, b, c] = mesh.corners(handle_of<Face>(f));
        faces.add(std::array{static_cast<Corner>(a), static_cast<Corner>(b), static_cast<Corner>(c)});
    }
    return mesh_topology(mesh.vertex_count(), faces);
}

Corner number(Vertex v) {
    return static_cast<Corner>(to_index(v));
}

std::multiset<Triangle> triangles_of(const TriangleMesh& mesh) {
    std::vector<Corner> corners;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const Vertex corner : mesh.corners(handle_of<Face>(f))) corners.push_back(number(corner));
    return Triangles(mesh.vertex_count(), corners).sorted();
}

/// Every array against the others.
void expect_consistent(const TriangleMesh& mesh) {
    std::set<Edge> edges;
    std::map<Vertex, std::size_t> leaving;
    std::map<Vertex, std::size_t> ends;
    for (std::size_t i = 0; i < 3 * mesh.face_count(); ++i) {
        const auto h = handle_of<HalfEdge>(i);
        const HalfEdge twin = mesh.twin(h);
        ASSERT_LT(to_index(mesh.origin(h)), mesh.vertex_count());
        ASSERT_LT(to_index(mesh.edge(h)), mesh.edge_count());
        edges.insert(mesh.edge(h));
        ++leaving[mesh.origin(h)];
        ++ends[mesh.origin(h)];
        const HalfEdge named = mesh.half_edge(mesh.edge(h));
        ASSERT_TRUE(named == h || (named == twin && twin != no_half_edge));
        if (twin == no_half_edge) {
            ++ends[mesh.target(h)];
            ASSERT_EQ(mesh.half_edge(mesh.origin(h)), h) << "at a boundary the half-edge along it stands for a vertex";
            continue;
        }
        ASSERT_EQ(mesh.twin(twin), h);
        ASSERT_EQ(mesh.edge(twin), mesh.edge(h));
        ASSERT_EQ(mesh.origin(twin), mesh.target(h));
        ASSERT_EQ(mesh.target(twin), mesh.origin(h));
    }
    ASSERT_EQ(edges.size(), mesh.edge_count());
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const auto v = handle_of<Vertex>(i);
        ASSERT_EQ(mesh.origin(mesh.half_edge(v)), v);
        ASSERT_EQ(mesh.valence(v), ends[v]);
        ASSERT_EQ(mesh.is_boundary(v), leaving[v] + 1 == ends[v]);
    }
}

/// Equal to the last array, the half-edges of the vertices among them.
void expect_identical(const TriangleMesh& a, const TriangleMesh& b) {
    EXPECT_EQ(a, b);
    ASSERT_EQ(a.vertex_count(), b.vertex_count());
    for (std::size_t v = 0; v < a.vertex_count(); ++v)
        EXPECT_EQ(a.half_edge(handle_of<Vertex>(v)), b.half_edge(handle_of<Vertex>(v)));
}

/// The corners opposite an edge, from its half-edge on; the second only where there are two faces.
std::array<Vertex, 4> around(const TriangleMesh& mesh, Edge e) {
    const HalfEdge h = mesh.half_edge(e);
    const HalfEdge twin = mesh.twin(h);
    return {mesh.origin(h), mesh.target(h), mesh.origin(TriangleMesh::previous(h)),
            twin == no_half_edge ? mesh.origin(h) : mesh.origin(TriangleMesh::previous(twin))};
}

std::vector<Vertex> neighbours(const TriangleMesh& mesh, Vertex v) {
    std::vector<Vertex> ring;
    mesh.for_each_neighbour(v, [&](Vertex neighbour, Edge) { ring.push_back(neighbour); });
    return ring;
}

/// The end of the edge that goes straight on from edge m–a through m.
Vertex straight_on(const TriangleMesh& mesh, Vertex m, Vertex a) {
    const std::vector<Vertex> ring = neighbours(mesh, m);
    const auto at = static_cast<std::size_t>(std::ranges::find(ring, a) - ring.begin());
    return ring[(at + 2) % ring.size() == at ? at : mesh.is_boundary(m) ? ring.size() - 1 - at : (at + 2) % 4];
}

TEST(TriangleMesh, HasTheElementsOfItsTriangles) {
    for (const auto& [name, shape] : shapes()) {
        SCOPED_TRACE(name);
        const TriangleMesh mesh = mesh_of(shape);
        expect_consistent(mesh);
        EXPECT_EQ(triangles_of(mesh), Triangles(shape.vertices, shape.corners).sorted());
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            EXPECT_EQ(number(mesh.corners(handle_of<Face>(f))[0]), shape.corners[3 * f]);
    }
}

TEST(TriangleMesh, GoesCounterclockwiseRoundAVertex) {
    const TriangleMesh mesh = mesh_of({5, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}});
    EXPECT_THAT(neighbours(mesh, Vertex{0}), ElementsAre(Vertex{1}, Vertex{2}, Vertex{3}, Vertex{4}));
    EXPECT_THAT(neighbours(mesh, Vertex{1}), ElementsAre(Vertex{2}, Vertex{0}, Vertex{4}));
    EXPECT_EQ(mesh.edge_between(Vertex{1}, Vertex{3}), std::nullopt);
    EXPECT_EQ(mesh.edge_between(Vertex{4}, Vertex{1}), mesh.edge_between(Vertex{1}, Vertex{4}));
}

TEST(TriangleMesh, RefusesWhatIsNoMesh) {
    EXPECT_THROW((void)mesh_of({3, {0, 1, 3}}), std::invalid_argument);
    EXPECT_THROW((void)mesh_of({3, {0, 1}}), std::invalid_argument);
    EXPECT_THROW((void)mesh_of({4, {0, 1, 2, 0, 1, 3}}), std::invalid_argument);
}

TEST(Stellar, SplitsThatAreWeldedAgainLeaveEveryArrayAsItWas) {
    for (const auto& [name, shape] : shapes()) {
        SCOPED_TRACE(name);
        TriangleMesh mesh = mesh_of(shape);
        for (std::size_t e = 0; e < mesh.edge_count(); ++e) mesh.set_level(handle_of<Edge>(e), static_cast<int>(e) + 1);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            mesh.set_level(handle_of<Vertex>(v), static_cast<int>(v) + 7);
        const TriangleMesh before = mesh;
        for (std::size_t e = 0; e < before.edge_count(); ++e) {
            const EdgeSplit made = mesh.split(handle_of<Edge>(e));
            expect_consistent(mesh);
            EXPECT_EQ(mesh.level(made.halves[0]), static_cast<int>(e) + 1);
            EXPECT_EQ(mesh.level(made.halves[1]), 0);
            EXPECT_EQ(mesh.level(made.vertex), 0);
            EXPECT_EQ(mesh.weld(made.vertex, made.halves[0]), StellarRefusal::None);
            expect_identical(mesh, before);
        }
        for (std::size_t f = 0; f < before.face_count(); ++f) {
            const FaceSplit made = mesh.split(handle_of<Face>(f));
            expect_consistent(mesh);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(mesh.edge_between(made.vertex, before.corners(handle_of<Face>(f))[i]), made.spokes[i]);
            EXPECT_EQ(mesh.weld(made.vertex), StellarRefusal::None);
            expect_identical(mesh, before);
        }
    }
}

TEST(Stellar, FlipsAreTurnedBackAndFourOfThemAreNone) {
    std::size_t done = 0;
    for (const auto& [name, shape] : shapes()) {
        SCOPED_TRACE(name);
        TriangleMesh mesh = mesh_of(shape);
        const TriangleMesh before = mesh;
        for (std::size_t i = 0; i < before.edge_count(); ++i) {
            const auto e = handle_of<Edge>(i);
            if (mesh.flip(e) != StellarRefusal::None) {
                expect_identical(mesh, before);
                EXPECT_NE(mesh.unflip(e), StellarRefusal::None);
                continue;
            }
            ++done;
            EXPECT_NE(triangles_of(mesh), triangles_of(before));
            TriangleMesh turned = mesh;
            EXPECT_EQ(mesh.unflip(e), StellarRefusal::None);
            EXPECT_EQ(mesh, before);
            for (int turn = 0; turn < 3; ++turn) EXPECT_EQ(turned.flip(e), StellarRefusal::None);
            EXPECT_EQ(turned, before);
            mesh = before;
        }
    }
    EXPECT_GT(done, 40U);
}

/// One operator tried on a mesh and on its list of triangles, which must be a mesh afterwards exactly when it is done.
class Trial {
public:
    explicit Trial(const Shape& shape)
        : mesh(mesh_of(shape))
        , plain(shape.vertices, shape.corners) {}

    void split_edge(Edge e) {
        const auto [a, b, c, d] = around(mesh, e);
        plain.split_edge(number(a), number(b));
        (void)mesh.split(e);
        expect_same();
    }
    void split_face(Face f) {
        const auto [a, b, c] = mesh.corners(f);
        plain.split_face({number(a), number(b), number(c)});
        (void)mesh.split(f);
        expect_same();
    }
    void flip(Edge e) {
        Triangles flipped = plain;
        const auto [a, b, c, d] = around(mesh, e);
        const bool boundary = mesh.is_boundary(e);
        if (!boundary) flipped.flip(number(a), number(b), number(c), number(d));
        finish(mesh.flip(e), !boundary && flipped.is_mesh(), flipped);
    }
    void weld_edge(Vertex m, Edge kept) {
        const bool boundary = mesh.is_boundary(m);
        const auto [p, q, c, d] = around(mesh, kept);
        const bool possible =
            (p == m || q == m) && mesh.valence(m) == (boundary ? 3U : 4U) && (!boundary || mesh.is_boundary(kept));
        Triangles welded = plain;
        if (possible) welded.weld_edge(number(m), number(straight_on(mesh, m, p == m ? q : p)));
        // A hole of three edges would close: a mesh again, but of another kind.
        const bool same_kind = welded.edge_count() + (boundary ? 2 : 3) == plain.edge_count();
        finish(mesh.weld(m, kept), possible && same_kind && welded.is_mesh(), welded);
    }
    void weld_face(Vertex m) {
        const bool possible = !mesh.is_boundary(m) && mesh.valence(m) == 3;
        Triangles welded = plain;
        const std::vector<Vertex> ring = neighbours(mesh, m);
        if (possible) welded.weld_face(number(m), {number(ring[0]), number(ring[1]), number(ring[2])});
        finish(mesh.weld(m), possible && welded.is_mesh(), welded);
    }

    std::size_t done = 0;
    std::size_t refused = 0;
    TriangleMesh mesh;
    Triangles plain;

private:
    void finish(StellarRefusal refusal, bool expected, const Triangles& result) {
        ASSERT_EQ(refusal == StellarRefusal::None, expected) << description(refusal);
        ++(expected ? done : refused);
        if (expected) plain = result;
        expect_same();
    }
    void expect_same() {
        expect_consistent(mesh);
        ASSERT_EQ(mesh.vertex_count(), plain.vertex_count());
        ASSERT_EQ(triangles_of(mesh), plain.sorted());
    }
};

TEST(Stellar, OperatorsAreThoseOfPlainTrianglesAndRefuseWhatIsNoMesh) {
    std::size_t done = 0;
    std::size_t refused = 0;
    for (const auto& named : shapes()) {
        const Shape& shape = named.second;
        SCOPED_TRACE(named.first);
        const auto with = [&](auto operate) {
            Trial trial(shape);
            operate(trial);
            done += trial.done;
            refused += trial.refused;
        };
        const TriangleMesh mesh = mesh_of(shape);
        for (std::size_t i = 0; i < mesh.edge_count(); ++i) {
            const auto e = handle_of<Edge>(i);
            with([e](Trial& trial) { trial.split_edge(e); });
            with([e](Trial& trial) { trial.flip(e); });
            for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
                with([e, v](Trial& trial) { trial.weld_edge(handle_of<Vertex>(v), e); });
        }
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            with([f](Trial& trial) { trial.split_face(handle_of<Face>(f)); });
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            with([v](Trial& trial) { trial.weld_face(handle_of<Vertex>(v)); });
    }
    EXPECT_GT(done, 60U);
    EXPECT_GT(refused, 300U);
}

TEST(Stellar, LongRandomSequencesStayAMeshOfTheSameKind) {
    tests::Random random(3);
    std::size_t done = 0;
    std::size_t refused = 0;
    for (const auto& [name, shape] : shapes()) {
        SCOPED_TRACE(name);
        Trial trial(shape);
        const MeshTopology before = topology_of(trial.mesh);
        for (int step = 0; step < 400 && !testing::Test::HasFatalFailure(); ++step) {
            const auto e = handle_of<Edge>(random.below(trial.mesh.edge_count()));
            const auto v = handle_of<Vertex>(random.below(trial.mesh.vertex_count()));
            const std::size_t operation = random.below(trial.mesh.vertex_count() > 30 ? 10 : 6);
            if (operation == 0) trial.split_edge(e);
            if (operation == 1) trial.split_face(handle_of<Face>(random.below(trial.mesh.face_count())));
            if (operation == 2 || operation == 3) trial.flip(e);
            if (operation == 4 || operation == 6 || operation == 7) {
                const std::vector<Vertex> ring = neighbours(trial.mesh, v);
                trial.weld_edge(v, trial.mesh.edge_between(v, ring[random.below(ring.size())]).value());
            }
            if (operation == 5 || operation >= 8) trial.weld_face(v);
        }
        const MeshTopology after = topology_of(trial.mesh);
        EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
        EXPECT_EQ(after.components, before.components);
        EXPECT_EQ(after.boundary_loops, before.boundary_loops);
        EXPECT_EQ(after.genus, before.genus);
        done += trial.done;
        refused += trial.refused;
    }
    EXPECT_GT(done, 500U);
    EXPECT_GT(refused, 500U);
}

/// Loop's topology by stellar operators: every edge split, then the spokes between an old and a new vertex flipped.
TEST(Stellar, QuadrisectionIsASplitAndAFlipOfTheSpokesToOldVertices) {
    TriangleMesh mesh = mesh_of(octahedron);
    for (const auto& [vertices, faces] : {std::pair{18U, 32U}, std::pair{66U, 128U}}) {
        const std::size_t old = mesh.vertex_count();
        const std::size_t edges = mesh.edge_count();
        std::vector<Edge> spokes;
        for (std::size_t e = 0; e < edges; ++e) {
            const EdgeSplit made = mesh.split(handle_of<Edge>(e));
            spokes.insert(spokes.end(), made.spokes.begin(), made.spokes.end());
        }
        for (const Edge spoke : spokes) {
            const auto [a, b, c, d] = around(mesh, spoke);
            if (to_index(a) >= old && to_index(b) >= old) continue;
            EXPECT_EQ(mesh.flip(spoke), StellarRefusal::None);
        }
        EXPECT_EQ(mesh.vertex_count(), vertices);
        EXPECT_EQ(mesh.face_count(), faces);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            EXPECT_EQ(mesh.valence(handle_of<Vertex>(v)), v < 6 ? 4U : 6U);
    }
}

TEST(Stellar, RefusalsSayWhy) {
    TriangleMesh mesh = mesh_of(tetrahedron);
    EXPECT_EQ(mesh.flip(Edge{0}), StellarRefusal::DoubledEdge);
    EXPECT_EQ(mesh.weld(Vertex{0}), StellarRefusal::DoubledFace);
    EXPECT_EQ(mesh.weld(Vertex{0}, *mesh.edge_between(Vertex{1}, Vertex{2})), StellarRefusal::NotIncident);
    EXPECT_EQ(mesh.weld(Vertex{0}, *mesh.edge_between(Vertex{0}, Vertex{2})), StellarRefusal::Valence);
    TriangleMesh ring = mesh_of({5, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}});
    EXPECT_EQ(ring.flip(*ring.edge_between(Vertex{1}, Vertex{2})), StellarRefusal::Boundary);
    EXPECT_EQ(ring.weld(Vertex{1}), StellarRefusal::Boundary);
    EXPECT_EQ(ring.weld(Vertex{1}, *ring.edge_between(Vertex{0}, Vertex{1})), StellarRefusal::Across);
    EXPECT_EQ(ring.weld(Vertex{0}), StellarRefusal::Valence);
    std::set<std::string_view> sentences;
    for (int refusal = 0; refusal <= static_cast<int>(StellarRefusal::Across); ++refusal)
        sentences.insert(description(static_cast<StellarRefusal>(refusal)));
    EXPECT_EQ(sentences.size(), static_cast<std::size_t>(StellarRefusal::Across) + 1);
}

TEST(MeshTopology, IsThatOfKnownSurfaces) {
    const MeshTopology sphere = topology_of(mesh_of(octahedron));
    EXPECT_EQ(sphere.euler_characteristic, 2);
    EXPECT_EQ(sphere.genus, 0U);
    EXPECT_EQ(sphere.boundary_loops, 0U);
    EXPECT_EQ(sphere.boundary_edges, 0U);
    EXPECT_THAT(sphere.interior_valences, ElementsAre(Pair(4U, 6U)));
    const MeshTopology torus = topology_of(mesh_of(shapes().at("torus")));
    EXPECT_EQ(torus.euler_characteristic, 0);
    EXPECT_EQ(torus.genus, 1U);
    EXPECT_EQ(torus.components, 1U);
    EXPECT_THAT(torus.interior_valences, ElementsAre(Pair(6U, 12U)));
    const MeshTopology cylinder = topology_of(mesh_of(shapes().at("cylinder")));
    EXPECT_EQ(cylinder.euler_characteristic, 0);
    EXPECT_EQ(cylinder.genus, 0U);
    EXPECT_EQ(cylinder.boundary_loops, 2U);
    EXPECT_EQ(cylinder.boundary_edges, 6U);
    const MeshTopology two = topology_of(mesh_of(shapes().at("two components")));
    EXPECT_EQ(two.components, 2U);
    EXPECT_EQ(two.boundary_loops, 2U);
    EXPECT_EQ(two.euler_characteristic, 2);
    EXPECT_THAT(two.boundary_valences, ElementsAre(Pair(2U, 6U)));
    EXPECT_EQ(topology_of(mesh_of({0, {}})), MeshTopology{});
}

} // namespace
} // namespace internode
