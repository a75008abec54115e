// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_fault.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = MeshFaultKind;
using Corners = std::vector<std::uint32_t>;

TEST(MeshFaults, AreNoneOfMeshes) {
    EXPECT_THAT(mesh_faults(0, {}), IsEmpty());
    EXPECT_THAT(mesh_faults(3, Corners{0, 1, 2}), IsEmpty());
    EXPECT_THAT(mesh_faults(4, Corners{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}), IsEmpty());
    EXPECT_THAT(mesh_faults(4, Corners{0, 1, 2, 2, 1, 3}), IsEmpty());
}

TEST(MeshFaults, AreFoundEachWithItsElements) {
    const std::vector<std::pair<Corners, MeshFault>> cases{
        {{0, 1, 5}, {Kind::IndexOutOfRange, {5}, {0}}},
        {{0, 1, 2, 3, 4, 3}, {Kind::DegenerateFace, {3, 4, 3}, {1}}},
        {{0, 1, 2, 2, 1, 0, 0, 3, 4}, {Kind::DuplicateFace, {0, 1, 2}, {0, 1}}},
        {{0, 1, 2, 0, 1, 3, 2, 3, 4}, {Kind::Orientation, {0, 1}, {0, 1}}},
        {{0, 1, 2, 1, 0, 3, 0, 1, 4}, {Kind::NonManifoldEdge, {0, 1}, {0, 1, 2}}},
        {{0, 1, 2, 0, 3, 4}, {Kind::NonManifoldVertex, {0}, {0, 1}}},
        {{0, 1, 2, 1, 0, 3}, {Kind::IsolatedVertex, {4}, {}}},
    };
    for (const auto& [corners, fault] : cases) {
        const std::vector<MeshFault> found = mesh_faults(5, corners);
        ASSERT_FALSE(found.empty()) << description(fault);
        EXPECT_EQ(found.front(), fault) << description(found.front());
        EXPECT_EQ(found.size(), 1U) << description(fault);
    }
}

TEST(MeshFaults, OfAPinchedVertexNameItsFaces) {
    // Two rings of four triangles that share a vertex in their middle, and a chain beside a ring.
    const Corners rings{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 0, 5, 6, 0, 6, 7, 0, 7, 8, 0, 8, 5};
    EXPECT_THAT(mesh_faults(9, rings), ElementsAre(MeshFault{Kind::NonManifoldVertex, {0}, {0, 1, 2, 3, 4, 5, 6, 7}}));
    const Corners ring_and_chain(rings.begin(), rings.end() - 3);
    EXPECT_THAT(mesh_faults(9, ring_and_chain),
                ElementsAre(MeshFault{Kind::NonManifoldVertex, {0}, {0, 1, 2, 3, 4, 5, 6}}));
    const Corners chain(rings.begin(), rings.begin() + 9);
    EXPECT_THAT(mesh_faults(5, chain), IsEmpty());
}

TEST(MeshFaults, AreSentences) {
    EXPECT_EQ(description({Kind::NonManifoldEdge, {3, 7}, {0, 4, 9}}), "the edge 3 7 has 3 faces: 0, 4, 9");
    EXPECT_EQ(description({Kind::IndexOutOfRange, {12}, {3}}), "face 3 has a corner 12, and no vertex has that number");
    for (int kind = 0; kind <= static_cast<int>(Kind::IsolatedVertex); ++kind)
        EXPECT_FALSE(description({static_cast<Kind>(kind), {1}, {2}}).empty());
}

TEST(MeshFaults, RefuseBeforeAnyWork) {
    EXPECT_THROW((void)mesh_faults(3, Corners{0, 1}), std::invalid_argument);
    EXPECT_THAT(mesh_faults(std::size_t{1} << 31U, {}), ElementsAre(MeshFault{Kind::TooLarge, {}, {}}));
}

} // namespace
} // namespace internode
