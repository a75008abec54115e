// SPDX-License-Identifier: MIT

#include "internode/io/mesh/mesh_file.h"

#include "internode/io/file/limits.h"
#include "internode/io/mesh/mesh_writers.h"
#include "internode/mesh/mesh_fault.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>

#include <bit>
#include <filesystem>
#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Corners = std::vector<std::uint32_t>;

/// The mesh of a file that is right.
MeshFile file_of(const std::string& bytes) {
    ParsedMesh parsed = read_mesh(bytes, "mesh");
    for (const Diagnostic& error : parsed.errors) ADD_FAILURE() << to_string(error);
    return parsed.file.value_or(MeshFile{});
}

std::vector<Corners> corners_of(const FaceList& faces) {
    std::vector<Corners> all;
    for (std::size_t face = 0; face < faces.size(); ++face) all.emplace_back(faces[face].begin(), faces[face].end());
    return all;
}

/// "3:7: message" of the first error.
std::string refusal(const std::string& bytes) {
    const ParsedMesh parsed = read_mesh(bytes, "mesh");
    EXPECT_FALSE(parsed.file.has_value());
    if (parsed.errors.empty()) return "accepted";
    const Diagnostic& error = parsed.errors.front();
    return std::to_string(error.line) + ':' + std::to_string(error.column) + ": " + error.message;
}

const std::string triangle_stl = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                 "endloop\nendfacet\nendsolid\n";

const std::string ascii_ply = "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement vertex 4\r\nproperty float x\r\n"
                              "property uchar red\r\nproperty float y\r\nproperty double z\r\nelement face 2\r\n"
                              "property list uchar int vertex_indices\r\nproperty uchar flag\r\nelement edge 1\r\n"
                              "property int vertex1\r\nend_header\r\n0 9 0 0\r\n1 9 0 0.5\r\n\r\n1 9 1 0\r\n0 9 1 0\r\n"
                              "3 0 1 2 1\r\n3 0 2 3 1\r\n0\r\n";

TEST(MeshFile, OfObjHasFacesOfAnySizeByAnyNumbers) {
    const MeshFile file =
        file_of("# a comment\nv 0 0 0\nv 1 0 0 .5 .6 .7\n  v 1 1 \\\n 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                "o thing\ng part\nusemtl red\ns 1\nf 1/1 2/1/1 3//1 -1\nf 1// 4/ 5/1/\nv 0 0 1\nf 3 2 -1\n");
    EXPECT_EQ(file.format, MeshFileFormat::Obj);
    EXPECT_EQ(file.base(), 1U);
    EXPECT_THAT(file.mesh.points, ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1));
    EXPECT_THAT(corners_of(file.mesh.faces),
                ElementsAre(ElementsAre(0U, 1U, 2U, 3U), ElementsAre(0U, 3U, 4U), ElementsAre(2U, 1U, 4U)));
    EXPECT_THAT(file.vertex_lines, ElementsAre(2U, 3U, 4U, 6U, 15U));
    EXPECT_THAT(file.face_lines, ElementsAre(13U, 14U, 16U));
}

TEST(MeshFile, OfObjHasWhatIsSharp) {
    const MeshFile file =
        file_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nt crease 3/1/0 0 1 2 2.5\n"
                "t crease 3/2/0 0 1 2 1 10\nt corner 2/2/0 0 2 3 .5\nt interpolateboundary 1/0/0 2\n");
    EXPECT_THAT(file.mesh.creases, ElementsAre(SharpEdge{{0, 1}, 2.5}, SharpEdge{{1, 2}, 2.5}, SharpEdge{{0, 1}, 1},
                                               SharpEdge{{1, 2}, 10}));
    EXPECT_THAT(file.mesh.corners, ElementsAre(SharpVertex{0, 3}, SharpVertex{2, .5}));
}

TEST(MeshFile, OfOffHasItsElementsWhateverFollowsThem) {
    const MeshFile file =
        file_of("# first\nCOFF # colours\n4 2\t9\n0 0 0 255 0 0\n1 0 0 0 0 0 # here\n\n1 1 0\n0 1 .5# glued\n"
                "3 0 1 2 0.5 0.5 0.5\n4 0 1 2 3\n");
    EXPECT_EQ(file.format, MeshFileFormat::Off);
    EXPECT_THAT(file.mesh.points, ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, .5));
    EXPECT_THAT(corners_of(file.mesh.faces), ElementsAre(ElementsAre(0U, 1U, 2U), ElementsAre(0U, 1U, 2U, 3U)));
    EXPECT_THAT(file.vertex_lines, ElementsAre(4U, 5U, 7U, 8U));
    EXPECT_THAT(file.face_lines, ElementsAre(9U, 10U));
    EXPECT_EQ(file_of("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").mesh.faces.size(), 1U);
}

TEST(MeshFile, OfAsciiPlyHasItsElementsAmongOthers) {
    const MeshFile file = file_of(ascii_ply);
    EXPECT_EQ(file.format, MeshFileFormat::Ply);
    EXPECT_THAT(file.mesh.points, ElementsAre(0, 0, 0, 1, 0, 0.5, 1, 1, 0, 0, 1, 0));
    EXPECT_THAT(corners_of(file.mesh.faces), ElementsAre(ElementsAre(0U, 1U, 2U), ElementsAre(0U, 2U, 3U)));
    EXPECT_THAT(file.vertex_lines, ElementsAre(15U, 16U, 18U, 19U));
    EXPECT_THAT(file.face_lines, ElementsAre(20U, 21U));
}

/// Puts numbers as bytes, the most significant first or last.
struct Bytes {
    bool is_big;
    std::string text;

    template<typename T>
    Bytes& put(T value) {
        std::string bytes(sizeof value, '\0');
        for (std::size_t i = 0; i < sizeof value; ++i)
            bytes[is_big ? sizeof value - 1 - i : i] = static_cast<char>(std::uint64_t{value} >> (8 * i));
        text += bytes;
        return *this;
    }
    Bytes& put(float value) { return put(std::bit_cast<std::uint32_t>(value)); }
    Bytes& put(double value) { return put(std::bit_cast<std::uint64_t>(value)); }
};

TEST(MeshFile, OfBinaryPlyIsReadInBothOrdersAndEveryType) {
    for (const bool is_big : {false, true}) {
        Bytes bytes{is_big, std::string("ply\nformat binary_") + (is_big ? "big" : "little") +
                                "_endian 1.0\nelement vertex 3\nproperty short x\nproperty float y\nproperty double z\n"
                                "property list uint16 int8 spare\nelement face 2\nproperty char flag\n"
                                "property list int uint32 vertex_index\nend_header\n"};
        for (const int vertex : {0, 1, 2}) {
            bytes.put(static_cast<std::uint16_t>(-vertex)).put(0.5F * static_cast<float>(vertex)).put(0.25 * vertex);
            bytes.put(std::uint16_t{2}).put(std::uint8_t{7}).put(std::uint8_t{8});
        }
        bytes.put(std::uint8_t{1})
            .put(std::uint32_t{3})
            .put(std::uint32_t{0})
            .put(std::uint32_t{1})
            .put(std::uint32_t{2});
        bytes.put(std::uint8_t{1}).put(std::uint32_t{1}).put(std::uint32_t{0xFFFFFFFF});
        const MeshFile file = file_of(bytes.text);
        EXPECT_THAT(file.mesh.points, ElementsAre(0, 0, 0, -1, .5, .25, -2, 1, .5));
        EXPECT_THAT(corners_of(file.mesh.faces), ElementsAre(ElementsAre(0U, 1U, 2U), ElementsAre(0xFFFFFFFEU)));
        EXPECT_THAT(file.vertex_lines, IsEmpty());
        for (std::size_t size = 0; size < bytes.text.size(); ++size)
            EXPECT_FALSE(read_mesh(bytes.text.substr(0, size), "mesh").file.has_value()) << size;
    }
}

TEST(MeshFile, OfStlJoinsCornersWithTheSameNumbers) {
    const MeshFile file =
        file_of(triangle_stl + "solid again\nfacet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
                               "vertex -0 1 0\nendloop\nendfacet\nendsolid\n");
    EXPECT_EQ(file.format, MeshFileFormat::Stl);
    EXPECT_THAT(file.mesh.points, ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0));
    EXPECT_THAT(corners_of(file.mesh.faces), ElementsAre(ElementsAre(0U, 1U, 2U), ElementsAre(1U, 3U, 2U)));
    EXPECT_THAT(file.face_lines, ElementsAre(2U, 11U));
    Bytes bytes{false, std::string(80, 's')};
    bytes.put(std::uint32_t{2});
    for (const std::array<float, 9>& corners : {std::array{0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F},
                                                std::array{1.F, 0.F, 0.F, 1.F, 1.F, 0.F, -0.F, 1.F, 0.F}}) {
        for (int i = 0; i < 3; ++i) bytes.put(0.F);
        for (const float number : corners) bytes.put(number);
        bytes.put(std::uint16_t{0});
    }
    const MeshFile binary = file_of(bytes.text);
    EXPECT_EQ(binary.mesh.points, file.mesh.points);
    EXPECT_EQ(binary.mesh.faces, file.mesh.faces);
    EXPECT_THAT(binary.face_lines, IsEmpty());
    bytes.text.replace(84 + 12, 4, "\x00\x00\x80\x7f", 4);
    EXPECT_EQ(refusal(bytes.text), "0:0: triangle 0 has a coordinate that is not finite");
}

TEST(MeshFile, RefusesWithThePlace) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "0:0: the file has no face"},
        {"v 0 0 0\nl 1 1\n", "0:0: the file has no face"},
        {"v 0 x 0\n", "1:5: `x` is not a number within the range of doubles"},
        {"v 0 0\n", "1:1: a vertex needs x, y and z"},
        {"v 0 0 0\nf\n", "2:1: a face needs corners"},
        {"v 0 0 0\nf 1 /1 1\n", "2:5: `/1` is not a corner"},
        {"v 0 0 0\nf 1 1/0 1\n", "2:5: `1/0` is not a corner"},
        {"v 0 0 0\nf 1 1/// 1\n", "2:5: `1///` is not a corner"},
        {"v 0 0 0\nf 1 0 1\n", "2:5: `0` is not a corner"},
        {"v 0 0 0\nf 1 1//x 1\n", "2:5: `1//x` is not a corner"},
        {"v 0 0 0\nf 1 1/1/1/1 1\n", "2:5: `1/1/1/1` is not a corner"},
        {"v 0 0 0\nf 1 -2 1\n", "2:5: no vertex `-2`: 1 stands before"},
        {"v 0 0 0\nface 1 1 1\n", "2:1: `face` is no statement of OBJ"},
        {"call other.obj\n", "1:1: `call` reaches out of the file: it is not followed"},
        {"t crease\n", "1:1: a tag has a name and counts: `t crease 2/1/0 …`"},
        {"t crease 2/1\n", "1:10: a tag has a name and counts: `t crease 2/1/0 …`"},
        {"t crease 2/1/0 0\n", "1:1: a vertex of a tag is a number from 0"},
        {"t corner 1/1/0 0 sharp\n", "1:18: the sharpness of a tag is a number"},
        {"t crease 3/3/0 0 1 2 1 1 1\n", "1:1: a tag has one sharpness, or one for each of its edges or corners"},
        {"OFF", "0:0: the file ends before its counts"},
        {"4OFF\n", "1:1: vertices of other than three coordinates are not read"},
        {"OFF BINARY\n", "1:5: binary OFF is not read"},
        {"OFF\n1\n", "2:1: the numbers of vertices and of faces stand on one line"},
        {"OFF\n1 -1 0\n", "2:3: `-1` is not a whole number"},
        {"OFF\n40000001 1 0\n", "2:1: more than 40000000 vertices or faces, the limit"},
        {"OFF\n2 1 0\n0 0 0\n", "0:0: the file ends before vertex 1 of 2"},
        {"OFF\n1 1 0\n0 0\n", "3:1: a vertex needs x, y and z"},
        {"OFF\n1 2 0\n0 0 0\n1 0\n", "0:0: the file ends before face 1 of 2"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0\n", "4:1: a face of 3 corners with 2 numbers behind"},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 -0\n", "4:7: `-0` is not a whole number"},
        {"ply\n", "0:0: the header has no end"},
        {"ply\nend_header\n", "0:0: the header says no format"},
        {"ply\nformat ascii 1.0\nend_header\n", "0:0: the file has no element `face`"},
        {"ply\nformat text 1.0\nend_header\n", "2:13: the format is ascii, binary_little_endian or binary_big_endian"},
        {"ply\nformat ascii 1.0\nproperty float x\nend_header\n", "3:1: a property belongs to an element"},
        {"ply\nelement vertex\nend_header\n", "2:1: an element has a name and a number"},
        {"ply\nelement vertex many\nend_header\n", "2:16: `many` is not a whole number"},
        {"ply\nelement vertex 1\nproperty real x\nend_header\n", "3:10: `real` is no type of PLY"},
        {"ply\nelement vertex 1\nproperty x\nend_header\n",
         "3:1: a property has a type and a name: `float x`, `list uchar int …`"},
        {"ply\nelement face 1\nproperty list float int vertex_indices\nend_header\n",
         "3:15: the number of entries of a list is whole"},
        {"ply\nvertices 3\nend_header\n", "2:1: `vertices` is no line of a PLY header"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
         "0:0: the vertices have no `z`"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty int a\nend_header\n0\n",
         "0:0: the faces have no list `vertex_indices`"},
        {"ply\nformat ascii 1.0\nelement face 40000001\nproperty int a\nend_header\n0\n",
         "0:0: more than 40000000 vertices or faces, the limit"},
        {ascii_ply.substr(0, ascii_ply.size() - 14), "0:0: the file ends before face 1 of 2"},
        {ascii_ply.substr(0, ascii_ply.size() - 7), "21:1: the line ends too early"},
        {ascii_ply + "1 2", "accepted"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\nend_header\n-1\n",
         "6:1: a list has no such number of entries"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\nend_header\n1 0 0\n",
         "6:5: the line has more numbers than its element"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\nend_header\n1 -1\n",
         "6:1: the number of a vertex is whole, and not below 0"},
        {"solid\nfacet\nvertex 0 0\n", "3:1: a vertex stands in a triangle and has x, y and z"},
        {"solid\nvertex 0 0 0\n", "2:1: a vertex stands in a triangle and has x, y and z"},
        {"solid\nfacet\nvertex 0 0 0\nendfacet\n", "4:1: a triangle has three vertices"},
        {"solid\nfacet\nfacet\n", "3:1: a triangle within a triangle"},
        {"solid\nfaced\n", "2:1: `faced` is no statement of STL"},
        {triangle_stl.substr(0, triangle_stl.size() - 18), "0:0: the file ends within a triangle"},
    };
    for (const auto& [bytes, message] : cases) {
        if (message == "accepted")
            EXPECT_TRUE(read_mesh(bytes, "mesh").file.has_value()) << bytes;
        else
            EXPECT_EQ(refusal(bytes), message) << bytes;
    }
}

TEST(MeshFile, RefusesALineBeyondTheLimit) {
    const std::string text = "OFF\n1 1 0\n0 0 0\n3 0 0 0" + std::string(max_mesh_line_bytes, ' ') + "\n";
    EXPECT_EQ(refusal(text), "0:0: line 4 has more than 16777216 bytes, the limit");
}

TEST(MeshFile, PrefixesOfTextsAreReadOrRefused) {
    for (const std::string& text :
         {ascii_ply, triangle_stl, tests::content(tests::in_source_folder("data/meshes/box.off")),
          tests::content(tests::in_source_folder("data/meshes/tetrahedron.obj"))})
        for (std::size_t size = 0; size <= text.size(); ++size) {
            const ParsedMesh parsed = read_mesh(std::string_view(text).substr(0, size), "mesh");
            EXPECT_EQ(parsed.file.has_value(), parsed.errors.empty());
        }
}

TEST(MeshWriters, WriteWhatIsReadBack) {
    PolygonMesh mesh;
    mesh.points = {0, 0.1, 1.0 / 3, 1, 0, -1e-300, 1, 1, 5e20, 0, 1, 0, -2, 0, 0};
    mesh.faces.add(Corners{0, 1, 2, 3});
    mesh.faces.add(Corners{0, 3, 4});
    mesh.creases = {{{0, 3}, 2.5}, {{1, 2}, 10}};
    mesh.corners = {{4, 0.75}};
    const std::vector<std::string> comments{"by a test", "two\nlines"};
    StringSink obj;
    StringSink off;
    StringSink ply;
    EXPECT_TRUE(write_obj(obj, mesh, comments));
    EXPECT_TRUE(write_off(off, mesh, comments));
    EXPECT_TRUE(write_ply(ply, mesh, comments));
    const std::vector<std::pair<std::string, MeshFileFormat>> written{
        {obj.text(), MeshFileFormat::Obj}, {off.text(), MeshFileFormat::Off}, {ply.text(), MeshFileFormat::Ply}};
    for (const auto& [bytes, format] : written) {
        const MeshFile file = file_of(bytes);
        EXPECT_EQ(file.format, format);
        EXPECT_EQ(file.mesh.points, mesh.points);
        EXPECT_EQ(file.mesh.faces, mesh.faces);
        EXPECT_THAT(bytes, HasSubstr("by a test"));
    }
    EXPECT_EQ(file_of(obj.text()).mesh.creases, mesh.creases);
    EXPECT_EQ(file_of(obj.text()).mesh.corners, mesh.corners);
}

TEST(MeshWriters, RefuseACornerWithoutAVertex) {
    PolygonMesh mesh;
    mesh.points = {0, 0, 0};
    mesh.faces.add(Corners{0, 1, 0});
    StringSink sink;
    EXPECT_THROW((void)write_obj(sink, mesh), std::invalid_argument);
    EXPECT_THROW((void)write_off(sink, mesh), std::invalid_argument);
    EXPECT_THROW((void)write_ply(sink, mesh), std::invalid_argument);
}

TEST(MeshWriters, WritePlyOfFacesWithMoreCornersThanAByteSays) {
    for (const std::uint32_t corners : {255U, 256U}) {
        PolygonMesh mesh;
        Corners face;
        for (std::uint32_t corner = 0; corner < corners; ++corner) {
            mesh.points.insert(mesh.points.end(), {1.0 * corner, 0, 0});
            face.push_back(corner);
        }
        mesh.faces.add(face);
        StringSink ply;
        EXPECT_TRUE(write_ply(ply, mesh));
        EXPECT_EQ(file_of(ply.text()).mesh.faces, mesh.faces);
        EXPECT_THAT(ply.text(), HasSubstr(corners == 255 ? "list uchar int" : "list uint int"));
    }
}

/// Shapes of OpenSubdiv, where they stand beside the project: the non-manifold ones have their faults named.
TEST(MeshFile, ReadsTheShapesOfOpenSubdiv) {
    const std::filesystem::path folder = tests::in_source_folder("../shared/goldens/opensubdiv");
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "SKIPPED: no " << folder;
    std::size_t shapes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".obj") continue;
        ++shapes;
        const std::string name = entry.path().filename().string();
        const MeshFile file = file_of(tests::content(entry.path()));
        const std::vector<MeshFault> faults = mesh_faults(file.mesh.vertex_count(), file.mesh.faces);
        if (name.find("_L0") == std::string::npos) continue;
        const bool has_bow_tie = name.find("gregory_test4") != std::string::npos;
        const bool is_manifold = name.find("nonman") == std::string::npos && !has_bow_tie;
        EXPECT_EQ(faults.empty(), is_manifold)
            << name << ": " << (faults.empty() ? "" : description(faults.front(), 1));
        if (name.find("crease") != std::string::npos) {
            EXPECT_THAT(file.mesh.creases, testing::Not(IsEmpty())) << name;
        }
    }
    EXPECT_GT(shapes, 50U);
}

} // namespace
} // namespace internode
