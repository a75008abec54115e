// SPDX-License-Identifier: MIT
//
// The torus of rational biquadratic patches: what refinement and limits make of it stays on the torus.

#include "internode/curve/knot_vector.h"
#include "internode/io/file/input_file.h"
#include "internode/io/json/input_grid.h"
#include "internode/surface/limit.h"
#include "internode/surface/refinement.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/stride.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace internode {
namespace {

constexpr double major_radius = 2;
constexpr double tolerance = 1e-13;

const int deep = tests::in_full() ? 10 : 7;

InputGrid torus_file() {
    const InputText input = read_input(tests::in_source_folder("data/grids/torus.json"));
    return read_grid_json(input.text, "torus.json").grid.value();
}

/// The knots of one side under A -> A…A.
Knots side_knots(const InputGrid& file, std::size_t side, const std::string& rule) {
    const int degree = static_cast<int>(file.sides[side].degree.value());
    KnotVector vector{
        .degree = degree, .ends = Ends::Open, .points = side == 0 ? file.rows : file.columns, .knots = {}};
    for (const InputNumber& knot : file.sides[side].knots.value()) vector.knots.emplace_back(knot.front());
    const KnotWord word = fit_knots(tests::system_with({rule}), vector).fitted.value();
    return make_knots(word.system, {degree, Ends::Open, word.word}).knots.value();
}

Grid torus(const std::string& rule_u, const std::string& rule_v) {
    const InputGrid file = torus_file();
    return make_grid(
               {side_knots(file, 0, rule_u), side_knots(file, 1, rule_v), file.dimension, file.rational, file.points})
        .grid.value();
}

/// How far points lie from the tube of radius 1 round the circle of radius 2; and normals from the way out of it.
double distance(const Sheet& sheet) {
    double worst = 0;
    for (std::size_t i = 0; i < sheet.points.size(); i += 3) {
        const double x = sheet.points[i];
        const double y = sheet.points[i + 1];
        const double z = sheet.points[i + 2];
        const double around = std::hypot(x, y);
        worst = std::max(worst, std::abs(std::hypot(around - major_radius, z) - 1));
        if (sheet.normals.empty()) continue;
        const double* const normal = sheet.normals.data() + i;
        const double out = 1 - major_radius / around;
        const double direction = normal[0] * x * out + normal[1] * y * out + normal[2] * z;
        worst = std::max(worst, std::abs(std::abs(direction) - 1));
    }
    return worst;
}

TEST(Torus, StaysOneThroughTenStepsInEachDirection) {
    const Grid coarse = torus("AA", "AA");
    for (const auto& [u, v] : {std::pair{deep, 1}, std::pair{1, deep}, std::pair{6, 6}}) {
        const SurfaceLimit limit = surface_limit(refine(coarse, u, v), Normals::Unit);
        EXPECT_EQ(limit.parameters_u.size(), (std::size_t{4} << u) + 1);
        EXPECT_EQ(limit.parameters_v.size(), (std::size_t{4} << v) + 1);
        EXPECT_LE(distance(limit.sheet), tolerance) << u << ' ' << v;
    }
}

TEST(Torus, TakesAnotherGrammarOnEachSide) {
    const SurfaceLimit limit = surface_limit(refine(torus("AAA", "AAAAA"), 3, 2), Normals::None);
    EXPECT_EQ(limit.parameters_u.size(), 4U * 27 + 1);
    EXPECT_EQ(limit.parameters_v.size(), 4U * 25 + 1);
    EXPECT_LE(distance(limit.sheet), tolerance);
}

} // namespace
} // namespace internode
