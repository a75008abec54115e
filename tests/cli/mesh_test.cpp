// SPDX-License-Identifier: MIT

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace internode::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(MeshCommand, SaysWhatAMeshIs) {
    const Workspace here;
    const Outcome sphere = here.run({"mesh", "data/meshes/tetrahedron.obj"});
    EXPECT_EQ(sphere.code, 0) << sphere.err;
    EXPECT_EQ(sphere.out, "data/meshes/tetrahedron.obj, OBJ\n"
                          "  vertices               4\n"
                          "  edges                  6\n"
                          "  faces                  4\n"
                          "  faces of 3 corners     4\n"
                          "  components             1\n"
                          "  boundary loops         0\n"
                          "  boundary edges         0\n"
                          "  Euler characteristic   2\n"
                          "  genus                  0\n"
                          "  vertices of valence 3  4\n"
                          "  sharp edges            2\n"
                          "An oriented manifold without faults.\n");
    const Outcome box = here.run({"mesh", "data/meshes/box.off"});
    EXPECT_EQ(box.code, 0) << box.err;
    EXPECT_THAT(box.out, HasSubstr("boundary loops                    1\n"));
    EXPECT_THAT(box.out, HasSubstr("vertices of valence 3, boundary   4\n"));
}

TEST(MeshCommand, NamesEachFaultWithItsLine) {
    const Workspace here;
    const Outcome faulty = here.run({"mesh", "data/meshes/three-faces-at-an-edge.obj"});
    EXPECT_EQ(faulty.code, 1);
    EXPECT_THAT(
        faulty.out,
        HasSubstr("3 faults:\n"
                  "  data/meshes/three-faces-at-an-edge.obj:8: duplicate face: faces 1, 4 have the same corners "
                  "1 2 3\n"
                  "  data/meshes/three-faces-at-an-edge.obj:8: non-manifold edge: the edge 1 2 has 3 faces: 1, "
                  "2, 3\n"
                  "  data/meshes/three-faces-at-an-edge.obj:7: isolated vertex: vertex 6 has no face\n"));
    const Outcome json = here.run({"mesh", "data/meshes/three-faces-at-an-edge.obj", "--json"});
    EXPECT_EQ(json.code, 1);
    EXPECT_THAT(json.out, HasSubstr("\"topology\": null"));
    EXPECT_THAT(json.out, HasSubstr("\"kind\": \"non-manifold edge\",\n      \"vertices\": [0, 1],\n      \"faces\": "
                                    "[0, 1, 2],\n      \"lines\": [8, 9, 10]"));
}

TEST(MeshCommand, CutsLongListsShort) {
    const Workspace here;
    std::string fan = "v 0 0 0\nv 0 0 1\n";
    for (int i = 0; i < 30; ++i) fan += "v " + std::to_string(i) + " 1 0\n";
    for (int i = 0; i < 30; ++i) fan += "f 1 2 " + std::to_string(i + 3) + "\n";
    for (int i = 0; i < 40; ++i) fan += "f 1 1 2\n";
    const Outcome faulty = here.run({"mesh", "-"}, fan);
    EXPECT_EQ(faulty.code, 1);
    EXPECT_THAT(faulty.out,
                HasSubstr("41 faults:\n  <stdin>:63: degenerate face: face 31 has a corner twice: 1 1 2\n"));
    EXPECT_THAT(faulty.out, HasSubstr("  and 21 more\n"));
    const Outcome edge = here.run({"mesh", "-"}, fan.substr(0, fan.find("f 1 1 2")));
    EXPECT_THAT(edge.out, HasSubstr("<stdin>:33: non-manifold edge: the edge 1 2 has 8 faces: 1, 2, 3, 4, 5, 6, 7, 8 … "
                                    "of 30\n"));
}

TEST(MeshCommand, RepairsAndSaysWhatItDid) {
    const Workspace here;
    const Outcome repaired =
        here.run({"mesh", "data/meshes/three-faces-at-an-edge.obj", "--repair", "-o", "repaired.obj"});
    EXPECT_EQ(repaired.code, 0) << repaired.err;
    EXPECT_EQ(repaired.err, "data/meshes/three-faces-at-an-edge.obj: 1 duplicate face dropped, 1 edge cut, 4 vertices "
                            "added, 1 isolated vertex dropped\n");
    const Outcome again = here.run({"mesh", "repaired.obj"});
    EXPECT_EQ(again.code, 0) << again.out;
    EXPECT_THAT(again.out, HasSubstr("components                       3\n"));
    const Outcome whole = here.run({"mesh", "data/meshes/tetrahedron.obj", "--repair"});
    EXPECT_EQ(whole.err, "data/meshes/tetrahedron.obj: nothing to repair\n");
    EXPECT_THAT(whole.out, HasSubstr("t crease 2/1/0 0 1 2.5\nt crease 2/1/0 1 2 2.5\n"));
    const Outcome off = here.run({"mesh", "data/meshes/tetrahedron.obj", "--repair", "-o", "t.off"});
    EXPECT_EQ(off.code, 0);
    EXPECT_THAT(off.err, HasSubstr("warning: OFF does not say what is sharp\n"));
    EXPECT_EQ(here.run({"mesh", "t.off"}).code, 0);
    const Outcome binary = here.run({"mesh", "data/meshes/box.off", "--repair", "-o", "box.ply"});
    EXPECT_EQ(binary.code, 0) << binary.err;
    EXPECT_THAT(here.run({"mesh", "box.ply"}).out, StartsWith("box.ply, PLY\n  vertices                          8\n"));
}

TEST(MeshCommand, RefusesWhatIsNoMesh) {
    const Workspace here;
    expect_refused(here.run({"mesh", "-"}, "v 0 0 0\nf 1 x 2\n"), {"mesh"}, "<stdin>:2:5: error: `x` is not a corner");
    expect_refused(here.run({"mesh", "-"}, "1 2 3\n"), {"mesh"}, "<stdin>:1:1: error: `1` is no statement of OBJ");
    expect_refused(here.run({"mesh", "none.obj"}), {"mesh"}, "none.obj: error: no such file", 4);
}

} // namespace
} // namespace internode::tests
