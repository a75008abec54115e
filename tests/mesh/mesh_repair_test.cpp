// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_repair.h"

#include "internode/mesh/face_sides.h"
#include "internode/mesh/mesh_facts.h"
#include "internode/mesh/mesh_fault.h"
#include "tests/fixtures/random_curve.h"
#include "tests/reference/faces.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Corners = std::vector<std::uint32_t>;

FaceList list_of(const std::vector<Corners>& faces) {
    FaceList list;
    for (const Corners& corners : faces) list.add(corners);
    return list;
}

std::vector<Corners> corners_of(const FaceList& faces) {
    std::vector<Corners> all;
    for (std::size_t face = 0; face < faces.size(); ++face) all.emplace_back(faces[face].begin(), faces[face].end());
    return all;
}

/// Corners by the vertices that they were, from the smallest on, in the direction that has the smaller second one.
Corners as_before(std::span<const std::uint32_t> corners, const std::vector<std::uint32_t>& vertices) {
    Corners face;
    for (const std::uint32_t corner : corners) face.push_back(vertices.empty() ? corner : vertices[corner]);
    std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    if (face.back() < face[1]) std::reverse(face.begin() + 1, face.end());
    return face;
}

/// What holds for every repair.
void check_repair(std::size_t vertices, const FaceList& faces) {
    const RepairedMesh mesh = repaired(vertices, faces);
    SCOPED_TRACE(testing::PrintToString(corners_of(faces)));
    EXPECT_THAT(mesh_faults(mesh.vertices.size(), mesh.faces), IsEmpty());
    ASSERT_EQ(mesh.face_before.size(), mesh.faces.size());
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        Corners before(faces[mesh.face_before[face]].begin(), faces[mesh.face_before[face]].end());
        before.erase(std::unique(before.begin(), before.end()), before.end());
        while (before.front() == before.back()) before.pop_back();
        EXPECT_EQ(as_before(mesh.faces[face], mesh.vertices), as_before(before, {}));
    }
    EXPECT_EQ(mesh.faces.size() + mesh.done.faces_dropped + mesh.done.duplicates_dropped, faces.size());
    EXPECT_EQ(mesh.vertices.size() + mesh.done.vertices_dropped, vertices + mesh.done.vertices_added);
    // What is a mesh is left alone.
    const RepairedMesh again = repaired(mesh.vertices.size(), mesh.faces);
    EXPECT_EQ(again.done, MeshRepairs{});
    EXPECT_EQ(again.faces, mesh.faces);
}

TEST(MeshRepair, MakesAMeshOfAllSmallFaces) {
    const std::vector<Corners> all = reference::small_faces(5);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i; j < all.size(); ++j)
            for (std::size_t k = j; k < all.size(); k += 11) check_repair(5, list_of({all[i], all[j], all[k]}));
}

TEST(MeshRepair, MakesAMeshOfRandomFaces) {
    tests::Random random(11);
    for (int trial = 0; trial < 400; ++trial) {
        const std::size_t vertices = 3 + random.below(9);
        FaceList faces;
        for (std::size_t face = random.below(24); face-- > 0;) {
            Corners corners(2 + random.below(4));
            for (std::uint32_t& corner : corners) corner = static_cast<std::uint32_t>(random.below(vertices + 1));
            faces.add(corners);
        }
        check_repair(vertices, faces);
    }
}

TEST(MeshRepair, DropsWhatIsNoFace) {
    const RepairedMesh mesh =
        repaired(7, list_of({{0, 1, 2}, {0, 0, 1}, {2, 1, 1, 3, 2}, {1, 2, 0}, {3, 4}, {0, 1, 9}, {0, 3, 0, 4}}));
    EXPECT_THAT(corners_of(mesh.faces), ElementsAre(ElementsAre(0U, 1U, 2U), ElementsAre(2U, 1U, 3U)));
    EXPECT_THAT(mesh.face_before, ElementsAre(0U, 2U));
    EXPECT_EQ(mesh.done, (MeshRepairs{.corners_dropped = 2,
                                      .faces_dropped = 4,
                                      .duplicates_dropped = 1,
                                      .faces_turned = 0,
                                      .edges_cut = 0,
                                      .vertices_added = 0,
                                      .vertices_dropped = 3}));
}

TEST(MeshRepair, TurnsTheFewerFacesOfAComponent) {
    // A tetrahedron with one face turned, and another with three.
    const RepairedMesh mesh =
        repaired(8, list_of({{0, 1, 2}, {0, 3, 1}, {1, 2, 3}, {2, 3, 0}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}}));
    EXPECT_EQ(mesh.done, (MeshRepairs{.faces_turned = 1}));
    EXPECT_THAT(corners_of(mesh.faces)[2], ElementsAre(1U, 3U, 2U));
    const RepairedMesh other = repaired(4, list_of({{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    EXPECT_EQ(other.done, (MeshRepairs{.faces_turned = 1}));
    EXPECT_THAT(corners_of(other.faces)[0], ElementsAre(0U, 2U, 1U));
}

TEST(MeshRepair, CutsAnEdgeOfThreeFacesApart) {
    const RepairedMesh mesh = repaired(5, list_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
    EXPECT_EQ(mesh.done, (MeshRepairs{.edges_cut = 1, .vertices_added = 4}));
    EXPECT_THAT(mesh.vertices, ElementsAre(0U, 1U, 2U, 3U, 4U, 1U, 0U, 0U, 1U));
    EXPECT_EQ(mesh_topology(mesh.vertices.size(), mesh.faces).components, 3U);
}

TEST(MeshRepair, CutsAVertexOfTwoFans) {
    const RepairedMesh mesh = repaired(5, list_of({{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(mesh.done, (MeshRepairs{.vertices_added = 1}));
    EXPECT_THAT(mesh.vertices, ElementsAre(0U, 1U, 2U, 3U, 4U, 0U));
}

TEST(MeshRepair, CutsAMoebiusBandOnce) {
    const RepairedMesh mesh = repaired(5, list_of({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
    EXPECT_EQ(mesh.done.edges_cut, 1U);
    EXPECT_EQ(mesh.done.vertices_added, 2U);
    const MeshTopology strip = mesh_topology(mesh.vertices.size(), mesh.faces);
    EXPECT_EQ(strip.components, 1U);
    EXPECT_EQ(strip.boundary_loops, 1U);
    EXPECT_EQ(strip.euler_characteristic, 1);
}

TEST(MeshRepair, RefusesWhatHasTooManyVertices) {
    EXPECT_THROW((void)repaired(most_half_edges + 1, {}), std::invalid_argument);
}

} // namespace
} // namespace internode
