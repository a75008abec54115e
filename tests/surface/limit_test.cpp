// SPDX-License-Identifier: MIT

#include "internode/surface/limit.h"

#include "internode/surface/refinement.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/surfaces.h"
#include "tests/fixtures/words.h"
#include "tests/reference/surface_piece.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using reference::Real;
using ::testing::ElementsAre;
using tests::all_shapes;
using tests::fibonacci;
using tests::Random;
using tests::random_grid;
using tests::random_knots;
using tests::Shape;

const std::size_t stride = tests::stride();

DeBoorCurve knot_line(const Knots& knots) {
    return reference::de_boor_curve(make_curve(knots, 1, std::vector<double>(knots.size())).curve.value());
}

/// Where a row of the sheet lies: over which piece, and at which of its ends.
struct Place {
    std::size_t piece;
    Real parameter;
};

/// Breaks show as a parameter that comes twice, first from the left.
std::vector<Place> places(const Knots& knots, const std::vector<double>& parameters, bool last_from_left) {
    const DeBoorCurve line = knot_line(knots);
    std::vector<Place> result;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool twice = i + 1 < parameters.size() && parameters[i + 1] == parameters[i];
        const bool left = twice || (last_from_left && i + 1 == parameters.size());
        Place best{0, 0};
        Real distance = 1e-9L;
        for (std::size_t j = line.degree; j < line.points.size(); ++j) {
            const Real knot = line.knots[left ? j + 1 : j];
            if (line.knots[j] == line.knots[j + 1] || std::abs(knot - parameters[i]) >= distance) continue;
            distance = std::abs(knot - parameters[i]);
            best = {j, knot};
        }
        EXPECT_GT(best.piece, 0u) << parameters[i];
        result.push_back(best);
    }
    return result;
}

bool ends_from_left(const Knots& knots, const std::vector<double>& parameters) {
    const DeBoorCurve line = knot_line(knots);
    return std::abs(parameters.back() - static_cast<double>(line.end())) < 1e-9;
}

std::vector<Place> places(const Knots& knots, const std::vector<double>& parameters) {
    return places(knots, parameters, ends_from_left(knots, parameters));
}

/// check(i, j, place along u, place along v) for every point of the limit.
void for_points(const Grid& grid, const SurfaceLimit& limit,
                const std::function<void(std::size_t, const Place&, const Place&)>& check) {
    const std::vector<Place> u = places(grid.u(), limit.parameters_u);
    const std::vector<Place> v = places(grid.v(), limit.parameters_v);
    ASSERT_EQ(limit.sheet.rows, u.size());
    ASSERT_EQ(limit.sheet.columns, v.size());
    ASSERT_EQ(limit.sheet.points.size(), u.size() * v.size() * grid.space_dimension());
    for (std::size_t i = 0; i < u.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j) check(i * v.size() + j, u[i], v[j]);
}

/// Grids of all mixes of ends and many degrees, rational ones too; refined a little, so that steps count.
void for_grids(const std::function<void(const Grid&)>& check) {
    Random random(1);
    std::size_t number = 0;
    tests::Compared compared;
    for (const Shape shape_u : all_shapes)
        for (const Shape shape_v : all_shapes)
            for (const int degree : {1, 2, 3, 4}) {
                const bool rational = random.below(2) == 1;
                const Knots u = random_knots(random, fibonacci(), degree, shape_u, 2);
                const Knots v = random_knots(random, fibonacci(), 1 + (degree + 1) % 4, shape_v, 2);
                const Grid grid = random_grid(random, u, v, rational ? 4 : 3, rational);
                if (number++ % stride != 0) continue;
                check(refine(grid, degree % 2, 1 - degree % 2));
                ++compared;
            }
}

TEST(SurfaceLimit, IsTheSurfaceByDeBoor) {
    for_grids([](const Grid& grid) {
        const SurfaceLimit limit = surface_limit(grid, Normals::None);
        EXPECT_TRUE(limit.sheet.normals.empty());
        for_points(grid, limit, [&](std::size_t k, const Place& u, const Place& v) {
            const auto expected =
                reference::in_space(grid, reference::surface_piece(grid, u.piece, u.parameter, v.piece, v.parameter));
            for (std::size_t c = 0; c < expected.size(); ++c)
                EXPECT_NEAR(limit.sheet.points[k * expected.size() + c], static_cast<double>(expected[c]), 1e-13);
        });
    });
}

/// A central difference of the polynomial piece in space.
std::array<Real, 3> difference(const Grid& grid, const Place& u, const Place& v, Real hu, Real hv) {
    const auto at = [&](Real sign) {
        return reference::in_space(
            grid, reference::surface_piece(grid, u.piece, u.parameter + sign * hu, v.piece, v.parameter + sign * hv));
    };
    const auto after = at(1);
    const auto before = at(-1);
    return {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
}

TEST(SurfaceLimit, NormalsAreThoseOfFiniteDifferences) {
    std::size_t number = 0;
    std::size_t compared = 0;
    for_grids([&](const Grid& grid) {
        if (number++ % 3 != 0) return;
        const SurfaceLimit limit = surface_limit(grid, Normals::Unit);
        for_points(grid, limit, [&](std::size_t k, const Place& u, const Place& v) {
            constexpr Real h = 1e-6L;
            const auto s = difference(grid, u, v, h, 0);
            const auto t = difference(grid, u, v, 0, h);
            const Real n[3] = {s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
            const Real size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            // Differences say little of a normal where a tangent vanishes or the two are nearly parallel.
            if (size < 1e-3L * h * h) return;
            ++compared;
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(limit.sheet.normals[3 * k + c], static_cast<double>(n[c] / size), 1e-6);
        });
    });
    EXPECT_GT(compared, tests::in_full() ? 20U : 5U);
}

TEST(SurfaceLimit, OfTheUnitSphereIsItsOwnNormalPolesIncluded) {
    for (int steps = 0; steps < 4; ++steps) {
        const SurfaceLimit limit = surface_limit(refine(tests::unit_sphere(), steps, steps), Normals::Unit);
        for (std::size_t i = 0; i < limit.sheet.points.size(); ++i)
            EXPECT_NEAR(limit.sheet.normals[i], limit.sheet.points[i], 1e-12);
        EXPECT_EQ(limit.sheet.rows, std::size_t{4} << steps);
        EXPECT_EQ(limit.sheet.columns, (std::size_t{2} << steps) + 1);
    }
}

TEST(SurfaceLimit, OfATorusStaysOnItAndPointsOutwards) {
    const SurfaceLimit limit = surface_limit(refine(tests::torus(3, 1), 2, 3), Normals::Unit);
    const std::vector<double>& p = limit.sheet.points;
    for (std::size_t k = 0; k < p.size(); k += 3) {
        const double ring = std::sqrt(p[k] * p[k] + p[k + 1] * p[k + 1]);
        EXPECT_NEAR((ring - 3) * (ring - 3) + p[k + 2] * p[k + 2], 1, 1e-13);
        EXPECT_NEAR(limit.sheet.normals[k], (ring - 3) * p[k] / ring, 1e-12);
        EXPECT_NEAR(limit.sheet.normals[k + 1], (ring - 3) * p[k + 1] / ring, 1e-12);
        EXPECT_NEAR(limit.sheet.normals[k + 2], p[k + 2], 1e-12);
    }
}

TEST(SurfaceLimit, NormalsHaveLengthOneOrAreZero) {
    const Knots line = make_knots(fibonacci(), {1, Ends::Open, {a, a, a}}).knots.value();
    const Grid flat = tests::grid_of({line, line, 3, false, {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}});
    EXPECT_THAT(surface_limit(flat, Normals::Unit).sheet.normals, testing::Each(0.0));
    const Grid huge = tests::grid_of({line, line, 3, false, {0, 0, 0, 0, 1e300, 0, 1e300, 0, 0, 1e300, 1e300, 0}});
    const std::vector<double> down = surface_limit(huge, Normals::Unit).sheet.normals;
    for (std::size_t c = 0; c < down.size(); ++c) EXPECT_EQ(down[c], c % 3 == 2 ? 1.0 : 0.0);
    const Grid tiny = tests::grid_of({line, line, 3, false, {0, 0, 0, 0, 1e-300, 0, 1e-300, 0, 0, 1e-300, 1e-300, 0}});
    EXPECT_EQ(surface_limit(tiny, Normals::Unit).sheet.normals, down);
}

TEST(SurfaceLimit, AppearsTwiceAtABreakAndIsNotJoinedThere) {
    const Knots broken = make_knots(fibonacci(), {1, Ends::Open, {o, a, o, a, o}}).knots.value();
    const Knots line = make_knots(fibonacci(), {1, Ends::Open, {a, a, a}}).knots.value();
    const Grid grid = tests::grid_of({broken, line, 1, false, {0, 0, 1, 1, 5, 5, 6, 6}});
    const SurfaceLimit limit = surface_limit(grid, Normals::None);
    EXPECT_THAT(limit.sheet.points, ElementsAre(0, 0, 1, 1, 5, 5, 6, 6));
    EXPECT_EQ(limit.parameters_u[1], limit.parameters_u[2]);
    EXPECT_THAT(limit.sheet.joined_rows, ElementsAre(Join{0, 1}, Join{2, 3}));
    EXPECT_EQ(limit.sheet.joined_rows, control_sheet(grid).joined_rows);
}

TEST(SurfaceLimit, JoinsAClosedDirectionUnlessItsSeamBreaks) {
    const Knots line = make_knots(fibonacci(), {1, Ends::Open, {a, a, a}}).knots.value();
    const Knots ring = make_knots(fibonacci(), {2, Ends::Circular, {a, a, a}}).knots.value();
    const Grid whole = tests::grid_of({ring, line, 1, false, {0, 0, 1, 1, 2, 2}});
    EXPECT_THAT(surface_limit(whole, Normals::None).sheet.joined_rows, ElementsAre(Join{0, 1}, Join{1, 2}, Join{2, 0}));
    for (const Word& word : {Word{o, o, a, a}, Word{a, o, o, a}, Word{o, a, a, o}}) {
        const Knots cut = make_knots(fibonacci(), {2, Ends::Circular, word}).knots.value();
        const Sheet sheet =
            surface_limit(tests::grid_of({cut, line, 1, false, std::vector<double>(8)}), Normals::None).sheet;
        EXPECT_EQ(sheet.rows, 3u); // two intervals, whichever of their ends meet
        EXPECT_EQ(sheet.joined_rows.size(), 2u);
    }
}

TEST(SurfaceLimit, RefusesNormalsOutsideSpace) {
    const Knots line = make_knots(fibonacci(), {1, Ends::Open, {a, a, a}}).knots.value();
    const Grid plane = tests::grid_of({line, line, 2, false, std::vector<double>(8)});
    const Grid rational = tests::grid_of({line, line, 3, true, std::vector<double>(12, 1)});
    EXPECT_THROW((void)surface_limit(plane, Normals::Unit), std::invalid_argument);
    EXPECT_THROW((void)surface_limit(rational, Normals::Unit), std::invalid_argument);
    EXPECT_NO_THROW((void)surface_limit(plane, Normals::None));
}

} // namespace
} // namespace internode
