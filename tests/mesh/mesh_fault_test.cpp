// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_fault.h"

#include "internode/mesh/face_sides.h"
#include "tests/reference/faces.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = MeshFaultKind;
using Corners = std::vector<std::uint32_t>;

FaceList faces_of(const std::vector<Corners>& faces) {
    FaceList list;
    for (const Corners& corners : faces) list.add(corners);
    return list;
}

TEST(MeshFaults, AreNoneOfMeshes) {
    EXPECT_THAT(mesh_faults(0, {}), IsEmpty());
    EXPECT_THAT(mesh_faults(3, triangles(Corners{0, 1, 2})), IsEmpty());
    EXPECT_THAT(mesh_faults(4, triangles(Corners{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0})), IsEmpty());
    EXPECT_THAT(mesh_faults(4, triangles(Corners{0, 1, 2, 2, 1, 3})), IsEmpty());
    EXPECT_THAT(mesh_faults(7, faces_of({{0, 1, 2, 3}, {3, 2, 4, 5, 6}})), IsEmpty());
}

TEST(MeshFaults, AreFoundEachWithItsElements) {
    const std::vector<std::pair<std::vector<Corners>, MeshFault>> cases{
        {{{0, 1, 5}, {2, 3, 4}}, {Kind::IndexOutOfRange, {5}, {0}}},
        {{{0, 1, 2}, {3, 4, 3}}, {Kind::DegenerateFace, {3, 4, 3}, {1}}},
        {{{0, 1, 2, 0, 3, 4}}, {Kind::DegenerateFace, {0, 1, 2, 0, 3, 4}, {0}}},
        {{{0, 1, 2}, {3, 4}}, {Kind::DegenerateFace, {3, 4}, {1}}},
        {{{0, 1, 2}, {2, 1, 0}, {0, 3, 4}}, {Kind::DuplicateFace, {0, 1, 2}, {0, 1}}},
        {{{4, 0, 2, 1, 3}, {0, 1, 2, 3, 4}}, {Kind::DuplicateFace, {0, 1, 2, 3, 4}, {0, 1}}},
        {{{0, 1, 2}, {0, 1, 3, 4}}, {Kind::Orientation, {0, 1}, {0, 1}}},
        {{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {Kind::NonManifoldEdge, {0, 1}, {0, 1, 2}}},
        {{{0, 1, 2}, {0, 3, 4}}, {Kind::NonManifoldVertex, {0}, {0, 1}}},
        {{{0, 1, 2}, {1, 0, 3}}, {Kind::IsolatedVertex, {4}, {}}},
    };
    for (const auto& [faces, fault] : cases)
        EXPECT_THAT(mesh_faults(5, faces_of(faces)), ElementsAre(fault)) << description(fault);
}

TEST(MeshFaults, AreToldTogetherWhereTheyAreApart) {
    const std::vector<MeshFault> faults =
        mesh_faults(14, faces_of({{0, 1, 99}, {2, 3, 4}, {4, 3, 2}, {5, 6, 7}, {5, 6, 8}, {9, 10, 11}, {9, 12, 12}}));
    EXPECT_THAT(faults,
                ElementsAre(MeshFault{Kind::IndexOutOfRange, {99}, {0}},
                            MeshFault{Kind::DegenerateFace, {9, 12, 12}, {6}},
                            MeshFault{Kind::DuplicateFace, {2, 3, 4}, {1, 2}},
                            MeshFault{Kind::Orientation, {5, 6}, {3, 4}}, MeshFault{Kind::IsolatedVertex, {13}, {}}));
}

TEST(MeshFaults, OfAPinchedVertexNameItsFaces) {
    // Two rings of four triangles that share a vertex in their middle, and a chain beside a ring.
    const Corners rings{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 0, 5, 6, 0, 6, 7, 0, 7, 8, 0, 8, 5};
    EXPECT_THAT(mesh_faults(9, triangles(rings)),
                ElementsAre(MeshFault{Kind::NonManifoldVertex, {0}, {0, 1, 2, 3, 4, 5, 6, 7}}));
    const Corners ring_and_chain(rings.begin(), rings.end() - 3);
    EXPECT_THAT(mesh_faults(9, triangles(ring_and_chain)),
                ElementsAre(MeshFault{Kind::NonManifoldVertex, {0}, {0, 1, 2, 3, 4, 5, 6}}));
    const Corners chain(rings.begin(), rings.begin() + 9);
    EXPECT_THAT(mesh_faults(5, triangles(chain)), IsEmpty());
}

/// Against the definitions, looked up face by face: every pair and every triple of faces of three and four corners
/// among five vertices.
TEST(MeshFaults, AreThoseOfTheDefinitionsForAllSmallFaces) {
    std::size_t meshes = 0;
    const auto check = [&meshes](const std::vector<Corners>& faces) {
        const std::vector<MeshFault> faults = mesh_faults(5, faces_of(faces));
        std::set<Kind> kinds;
        for (const MeshFault& fault : faults) kinds.insert(fault.kind);
        const std::set<Kind> expected = reference::fault_kinds(5, faces);
        // Each that is told is there, and where there is one, one is told.
        EXPECT_TRUE(std::ranges::includes(expected, kinds)) << testing::PrintToString(faces);
        EXPECT_EQ(kinds.empty(), expected.empty()) << testing::PrintToString(faces);
        meshes += faults.empty() ? 1 : 0;
    };
    const std::vector<Corners> all = reference::small_faces(5);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i; j < all.size(); ++j) {
            check({all[i], all[j]});
            for (std::size_t k = j; k < all.size(); k += 7) check({all[i], all[j], all[k]});
        }
    EXPECT_GT(meshes, 20U);
}

TEST(MeshFaults, AreSentences) {
    EXPECT_EQ(description({Kind::NonManifoldEdge, {3, 7}, {0, 4, 9}}), "the edge 3 7 has 3 faces: 0, 4, 9");
    EXPECT_EQ(description({Kind::NonManifoldEdge, {3, 7}, {0, 4, 9}}, 1), "the edge 4 8 has 3 faces: 1, 5, 10");
    EXPECT_EQ(description({Kind::IndexOutOfRange, {12}, {3}}), "face 3 has a corner 12, and no vertex has that number");
    EXPECT_EQ(description({Kind::DegenerateFace, {1, 2}, {3}}), "face 3 has fewer than three corners: 1 2");
    std::set<std::string_view> names;
    for (int kind = 0; kind <= static_cast<int>(Kind::IsolatedVertex); ++kind) {
        EXPECT_FALSE(description({static_cast<Kind>(kind), {1}, {2}}).empty());
        names.insert(name_of(static_cast<Kind>(kind)));
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(Kind::IsolatedVertex) + 1);
}

TEST(MeshFaults, RefuseBeforeAnyWork) {
    EXPECT_THROW((void)triangles(Corners{0, 1}), std::invalid_argument);
    EXPECT_THAT(mesh_faults(most_half_edges + 1, {}), ElementsAre(MeshFault{Kind::TooLarge, {}, {}}));
}

} // namespace
} // namespace internode
