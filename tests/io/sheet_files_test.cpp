// SPDX-License-Identifier: MIT

#include "internode/io/sheet_files.h"

#include "internode/surface/limit.h"
#include "internode/surface/refinement.h"
#include "tests/fixtures/mesh_files.h"
#include "tests/fixtures/surfaces.h"

#include <gmock/gmock.h>

#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace internode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::MeshFile;

using Write = bool (*)(Sink&, const Sheet&, std::span<const std::string>);

/// On two threads, which change no byte.
bool put_obj(Sink& sink, const Sheet& sheet, std::span<const std::string> comments) {
    return write_obj(sink, sheet, comments, 2);
}

std::string written(Write write, const Sheet& sheet, const std::vector<std::string>& comments = {}) {
    StringSink sink;
    EXPECT_TRUE(write(sink, sheet, comments));
    return sink.text();
}

/// Sheets of all kinds of ends, with and without normals.
std::vector<Sheet> sheets() {
    std::vector<Sheet> result;
    tests::Random random(1);
    for (const tests::Shape shape : tests::all_shapes) {
        const Knots u = tests::random_knots(random, tests::fibonacci(), 2, shape, 3);
        const Knots v = tests::random_knots(random, tests::fibonacci(), 3, tests::Shape::Closed, 4);
        const Grid grid = tests::random_grid(random, u, v, 4, true);
        result.push_back(control_sheet(grid));
        result.push_back(surface_limit(grid, Normals::Unit).sheet);
    }
    return result;
}

void expect_same_faces(const MeshFile& mesh, const Sheet& sheet) {
    ASSERT_EQ(mesh.faces.size(), sheet.faces());
    for (std::size_t f = 0; f < sheet.faces(); ++f) {
        const auto face = sheet.face(f);
        EXPECT_THAT(mesh.faces[f], ElementsAre(face[0], face[1], face[2], face[3]));
    }
}

TEST(SheetFiles, ObjIsReadBackBitForBit) {
    for (const Sheet& sheet : sheets()) {
        const MeshFile mesh = tests::read_obj(written(put_obj, sheet));
        EXPECT_EQ(mesh.points, sheet.points);
        EXPECT_EQ(mesh.normals, sheet.normals);
        expect_same_faces(mesh, sheet);
    }
}

TEST(SheetFiles, PlyIsReadBackWithNormalsAsFloats) {
    for (const Sheet& sheet : sheets()) {
        const MeshFile mesh = tests::read_ply(written(write_ply, sheet));
        EXPECT_EQ(mesh.points, sheet.points);
        ASSERT_EQ(mesh.normals.size(), sheet.normals.size());
        for (std::size_t i = 0; i < mesh.normals.size(); ++i)
            EXPECT_EQ(mesh.normals[i], double{static_cast<float>(sheet.normals[i])});
        expect_same_faces(mesh, sheet);
    }
}

TEST(SheetFiles, StlCutsEachFaceInTwoTriangles) {
    for (const Sheet& sheet : sheets()) {
        const MeshFile mesh = tests::read_stl(written(write_stl, sheet));
        ASSERT_EQ(mesh.faces.size(), 2 * sheet.faces());
        for (std::size_t f = 0; f < sheet.faces(); ++f) {
            const auto corner = sheet.face(f);
            const std::size_t order[] = {corner[0], corner[1], corner[2], corner[0], corner[2], corner[3]};
            for (std::size_t k = 0; k < 6; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(mesh.points[18 * f + 3 * k + c],
                              double{static_cast<float>(sheet.points[3 * order[k] + c])});
        }
    }
}

TEST(SheetFiles, FacesAreCounterclockwiseSeenFromTheNormal) {
    const Sheet sheet = surface_limit(refine(tests::torus(3, 1), 2, 2), Normals::Unit).sheet;
    const MeshFile stl = tests::read_stl(written(write_stl, sheet));
    for (std::size_t t = 0; t < stl.faces.size(); ++t) {
        const auto corner = sheet.face(t / 2);
        double along = 0;
        double length = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            along += stl.normals[3 * t + c] * sheet.normals[3 * corner[0] + c];
            length += stl.normals[3 * t + c] * stl.normals[3 * t + c];
        }
        EXPECT_GT(along, 0.7);
        EXPECT_NEAR(length, 1, 1e-6);
    }
}

/// Every edge is passed once in each direction.
TEST(SheetFiles, AClosedSurfaceHasNoBorder) {
    const Sheet sheet = control_sheet(tests::torus(3, 1));
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (std::size_t f = 0; f < sheet.faces(); ++f)
        for (std::size_t k = 0; k < 4; ++k) ++edges[{sheet.face(f)[k], sheet.face(f)[(k + 1) % 4]}];
    EXPECT_EQ(edges.size(), 4 * sheet.faces());
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
}

Sheet square(std::size_t dimension, std::vector<double> points) {
    Sheet sheet;
    sheet.rows = 2;
    sheet.columns = 2;
    sheet.dimension = dimension;
    sheet.points = std::move(points);
    sheet.joined_rows = {{0, 1}};
    sheet.joined_columns = {{0, 1}};
    return sheet;
}

TEST(SheetFiles, PadCoordinatesWithZero) {
    const Sheet flat = square(2, {0, 0, 0, 1, 1, 0, 1, 1});
    EXPECT_EQ(written(put_obj, flat), "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nf 1 3 4 2\n");
    EXPECT_THAT(tests::read_ply(written(write_ply, flat)).points, ElementsAre(0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0));
    const MeshFile stl = tests::read_stl(written(write_stl, flat));
    EXPECT_THAT(stl.normals, ElementsAre(0, 0, 1, 0, 0, 1));
}

TEST(SheetFiles, TrianglesWithoutAreaHaveNoNormal) {
    const MeshFile stl = tests::read_stl(written(write_stl, square(1, {1, 1, 2, 2})));
    EXPECT_THAT(stl.normals, testing::Each(0.0));
}

TEST(SheetFiles, KeepHostileCommentsOnTheirLine) {
    const Sheet flat = square(1, {0, 0, 0, 0});
    const std::string hostile = "a\nend_header\nv 9 9 9\x1b[2J";
    EXPECT_THAT(written(put_obj, flat, {hostile}), testing::StartsWith("# a?end_header?v 9 9 9?[2J\nv 0 0 0\n"));
    const MeshFile ply = tests::read_ply(written(write_ply, flat, {hostile, "b"}));
    EXPECT_THAT(ply.header, HasSubstr("comment a?end_header?v 9 9 9?[2J\ncomment b\nelement vertex 4\n"));
    const MeshFile stl = tests::read_stl(written(write_stl, flat, {std::string(500, 's')}));
    EXPECT_EQ(stl.header, "binary STL: " + std::string(68, 's'));
}

TEST(SheetFiles, RefuseWhatTheFormatCannotHold) {
    StringSink sink;
    for (const std::size_t dimension : {0u, 4u}) {
        const Sheet sheet = square(dimension, std::vector<double>(4 * dimension));
        EXPECT_THROW(write_obj(sink, sheet), std::invalid_argument);
        EXPECT_THROW(write_ply(sink, sheet), std::invalid_argument);
        EXPECT_THROW(write_stl(sink, sheet), std::invalid_argument);
    }
    for (const double value : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const Sheet sheet = square(1, {0, 0, 0, value});
        EXPECT_THROW(write_obj(sink, sheet), std::invalid_argument);
        EXPECT_THROW(write_ply(sink, sheet), std::invalid_argument);
        EXPECT_THROW(write_stl(sink, sheet), std::invalid_argument);
    }
    const Sheet large = square(1, {0, 0, 0, 1e39});
    EXPECT_THROW(write_stl(sink, large), std::invalid_argument);
    EXPECT_NO_THROW(write_ply(sink, large));
    Sheet missing = square(1, {0, 0, 0});
    EXPECT_THROW(write_obj(sink, missing), std::invalid_argument);
    missing.points.push_back(0);
    missing.normals = {0, 0, 1};
    EXPECT_THROW(write_obj(sink, missing), std::invalid_argument);
}

/// Counts alone, with no memory behind them.
TEST(SheetFiles, SayWhichNumbersAreTooLarge) {
    Sheet sheet = square(1, {0, 0, 0, 0});
    sheet.joined_rows.assign(std::size_t{1} << 16U, Join{0, 1});
    sheet.joined_columns.assign(std::size_t{1} << 15U, Join{0, 1});
    EXPECT_THAT(mesh_problem(sheet, MeshFormat::Stl).value(), HasSubstr("2147483648 faces"));
    sheet.joined_columns.pop_back();
    EXPECT_FALSE(mesh_problem(sheet, MeshFormat::Stl).has_value());
    EXPECT_FALSE(mesh_problem(sheet, MeshFormat::Ply).has_value());
}

class FailingSink final : public Sink {
public:
    explicit FailingSink(std::size_t room)
        : room_(room) {}
    bool write(std::string_view bytes) override {
        const bool fits = bytes.size() <= room_;
        room_ = fits ? room_ - bytes.size() : 0;
        return fits;
    }

private:
    std::size_t room_;
};

TEST(SheetFiles, StopWhenTheSinkFails) {
    const Sheet sheet = surface_limit(refine(tests::torus(3, 1), 5, 5), Normals::Unit).sheet;
    for (const std::size_t room : {0u, 70'000u, 300'000u}) {
        for (const Write write : {Write{put_obj}, Write{write_ply}, Write{write_stl}}) {
            FailingSink sink(room);
            EXPECT_FALSE(write(sink, sheet, {}));
        }
    }
}

} // namespace
} // namespace internode
