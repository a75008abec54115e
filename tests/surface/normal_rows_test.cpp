// SPDX-License-Identifier: MIT

#include "internode/surface/limit.h"
#include "internode/surface/refinement.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/surfaces.h"
#include "tests/reference/de_boor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace internode {
namespace {

using reference::ExactCurve;
using tests::fibonacci;
using tests::Random;
using tests::random_grid;
using tests::random_knots;
using tests::Shape;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

using Point = std::vector<Number>;

/// One direction of a grid in exact numbers; its points are to be filled in.
ExactCurve exact_line(const Knots& knots) {
    return reference::exact_curve(make_curve(knots, 1, std::vector<double>(knots.size())).curve.value());
}

/// The knots of the domain in order, the end too when open, and the pieces that they belong to.
struct Stations {
    std::vector<Number> knots;
    std::vector<std::size_t> pieces;
};

Stations stations(const Knots& given, const Knots& fine) {
    const ExactCurve line = exact_line(fine);
    const ExactCurve coarse = exact_line(given);
    Stations result;
    for (std::size_t j = line.degree; j < line.points.size(); ++j)
        if (line.knots[j] != line.knots[j + 1]) result.knots.push_back(line.knots[j]);
    if (given.ends() == Ends::Open) result.knots.push_back(line.end());
    for (const Number& knot : result.knots) {
        std::size_t piece = 0;
        for (std::size_t j = coarse.degree; j < coarse.points.size(); ++j)
            if (coarse.knots[j] < coarse.knots[j + 1] && coarse.knots[j] <= knot) piece = j;
        result.pieces.push_back(piece);
    }
    return result;
}

/// A derivative of that order in each direction, by de Boor's algorithm in exact numbers; and its largest difference.
class ExactPartial {
public:
    ExactPartial(const Grid& grid, int order_u, int order_v)
        : grid_(grid)
        , order_u_(order_u)
        , order_v_(order_v) {}

    Point at(std::size_t i, const Number& x, std::size_t j, const Number& y) {
        ExactCurve column = exact_line(grid_.u());
        const std::size_t size = grid_.u().size();
        const std::size_t d = column.degree;
        const std::size_t shift = grid_.u().ends() == Ends::Circular ? d * size - d : 0;
        for (std::size_t m = 0; m < column.points.size(); ++m) column.points[m] = row_at((m + shift) % size, j, y);
        return value(column, order_u_, i, x);
    }
    [[nodiscard]] double largest() const { return largest_; }

private:
    Point row_at(std::size_t row, std::size_t j, const Number& y) {
        const std::size_t size = grid_.v().size() * grid_.dimension();
        const auto first = grid_.points().begin() + static_cast<std::ptrdiff_t>(row * size);
        const Curve curve =
            make_curve(grid_.v(), grid_.dimension(), {first, first + static_cast<std::ptrdiff_t>(size)}).curve.value();
        return value(reference::exact_curve(curve), order_v_, j, y);
    }
    Point value(const ExactCurve& curve, int order, std::size_t j, const Number& x) {
        if (order == 0) return reference::de_boor_piece(curve, j, x);
        const ExactCurve slope = reference::derivative(curve);
        for (std::size_t k = j - slope.degree - 1; k < j; ++k)
            for (const Number& c : slope.points[k]) largest_ = std::max(largest_, std::abs(c.to_double()));
        return reference::de_boor_piece(slope, j - 1, x);
    }

    const Grid& grid_;
    int order_u_;
    int order_v_;
    double largest_ = 0;
};

Grid far_away(const Grid& grid) {
    std::vector<double> points;
    for (const double x : grid.points()) points.push_back(5e6 + x);
    return tests::grid_of({grid.u(), grid.v(), grid.dimension(), false, points});
}

std::array<double, 3> cross(const Point& a, const Point& b) {
    return {(a[1] * b[2] - a[2] * b[1]).to_double(), (a[2] * b[0] - a[0] * b[2]).to_double(),
            (a[0] * b[1] - a[1] * b[0]).to_double()};
}

/// Compares all normals; how many there were.
std::size_t expect_exact_normals(const Grid& given, int steps) {
    const Grid fine = refine(given, steps, steps);
    const SurfaceLimit limit = surface_limit(given, fine, Normals::Unit);
    const Stations u = stations(given.u(), fine.u());
    const Stations v = stations(given.v(), fine.v());
    EXPECT_EQ(limit.sheet.rows, u.knots.size());
    EXPECT_EQ(limit.sheet.columns, v.knots.size());
    std::size_t compared = 0;
    for (std::size_t i = 0; i < u.knots.size(); ++i)
        for (std::size_t j = 0; j < v.knots.size(); ++j) {
            ExactPartial du(given, 1, 0);
            ExactPartial dv(given, 0, 1);
            const Point s = du.at(u.pieces[i], u.knots[i], v.pieces[j], v.knots[j]);
            const Point t = dv.at(u.pieces[i], u.knots[i], v.pieces[j], v.knots[j]);
            const std::array<double, 3> n = cross(s, t);
            const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            // Tangents within 8 units of the largest difference, and what that turns their product by.
            const double tolerance = 16 * epsilon * (1 + du.largest() * dv.largest() / size);
            if (tolerance > 1e-10) continue; // nearly parallel
            ++compared;
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(limit.sheet.normals[(i * v.knots.size() + j) * 3 + c], n[c] / size, tolerance);
        }
    return compared;
}

TEST(NormalRows, FarFromTheOriginAreThoseOfExactTangents) {
    Random random(31);
    std::size_t compared = 0;
    for (const Shape shape_u : {Shape::Open, Shape::Closed, Shape::Clamped})
        for (const Shape shape_v : {Shape::Clamped, Shape::Closed, Shape::Open}) {
            const Knots u = random_knots(random, fibonacci(), static_cast<int>(1 + random.below(3)), shape_u, 2);
            const Knots v = random_knots(random, fibonacci(), static_cast<int>(1 + random.below(3)), shape_v, 2);
            compared += expect_exact_normals(far_away(random_grid(random, u, v, 3, false)), 1);
        }
    EXPECT_GT(compared, 60U);
}

/// A plane patch of 5 by 5 points in projected metres, `step` between them, and one of weights 1.
Grid plane(bool rational, double step) {
    const IntervalSystem system = tests::system_of("A->AA");
    const Knots knots = make_knots(system, {3, Ends::Open, tests::word_of(system, "000AA000")}).knots.value();
    std::vector<double> points;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j) {
            points.insert(points.end(), {1310000 + i * step, 6123456 + j * step, 100 + i * step / 2 - 2 * j * step});
            if (rational) points.push_back(1);
        }
    return tests::grid_of({knots, knots, std::size_t{rational ? 4U : 3U}, rational, points});
}

TEST(NormalRows, OfAPlaneAreTheSameAtEveryDepth) {
    const double length = std::sqrt(0.5 * 0.5 + 2 * 2 + 1);
    for (const bool rational : {false, true})
        for (const int steps : {0, 3, 6}) {
            const Grid grid = plane(rational, 0.125);
            const std::vector<double> normals =
                surface_limit(grid, refine(grid, steps, steps), Normals::Unit).sheet.normals;
            for (std::size_t i = 0; i < normals.size(); i += 3) {
                EXPECT_NEAR(normals[i], -0.5 / length, 4 * epsilon);
                EXPECT_NEAR(normals[i + 1], 2 / length, 4 * epsilon);
                EXPECT_NEAR(normals[i + 2], 1 / length, 4 * epsilon);
            }
        }
}

TEST(NormalRows, SeeDifferencesOfAFewUnitsInTheLastPlace) {
    // 2^-28 where neighbouring doubles are 2^-30 apart: nothing was rounded, so nothing is noise.
    const Grid grid = plane(false, 0x1p-28);
    const std::vector<double> normals = surface_limit(grid, refine(grid, 2, 2), Normals::Unit).sheet.normals;
    for (std::size_t i = 0; i < normals.size(); i += 3)
        EXPECT_NEAR(normals[i + 2], 1 / std::sqrt(0.5 * 0.5 + 2 * 2 + 1), 4 * epsilon);
}

/// Differences a, -a/2, a, -a/2, … of a uniform quartic: (a - 4 a/2 + a) / 6 = 0 at every other knot, but for rounding.
Grid with_stops_along(std::size_t side, const std::array<double, 3>& a) {
    const IntervalSystem system = tests::system_of("A->AA");
    const Knots stopping = make_knots(system, {4, Ends::Open, Word(12, to_symbol(0))}).knots.value();
    const Knots steady = make_knots(system, {1, Ends::Open, Word(3, to_symbol(0))}).knots.value();
    std::vector<double> points;
    for (std::size_t i = 0; i < (side == 0 ? 8U : 2U); ++i)
        for (std::size_t j = 0; j < (side == 0 ? 2U : 8U); ++j) {
            const std::size_t along = side == 0 ? i : j;
            const double times = static_cast<double>(along / 2) / 2 + static_cast<double>(along % 2);
            for (const double c : a) points.push_back(times * c);
            points.back() += 64 * static_cast<double>(i + j - along); // a straight line across
        }
    return side == 0 ? tests::grid_of({stopping, steady, 3, false, points})
                     : tests::grid_of({steady, stopping, 3, false, points});
}

TEST(NormalRows, AreNoneWhereATangentVanishesButForRounding) {
    for (const std::size_t side : {0U, 1U})
        for (const std::array<double, 3>& a : {std::array{0.1, 0.7, 0.3}, {0.3, -0.7, 0.9}, {-0.9, 0.1, 0.7}}) {
            const SurfaceLimit limit = surface_limit(with_stops_along(side, a), Normals::Unit);
            ASSERT_EQ(limit.sheet.rows * limit.sheet.columns, 10U);
            for (std::size_t i = 0; i < 10; ++i) {
                const std::size_t along = side == 0 ? i / 2 : i % 5;
                const double* const n = limit.sheet.normals.data() + 3 * i;
                EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), along % 2 == 0 ? 0 : 1, 4 * epsilon) << i;
            }
        }
}

TEST(NormalRows, OfTheGivenGridAreKeptAtItsKnots) {
    Random random(32);
    const Knots u = random_knots(random, fibonacci(), 3, Shape::Clamped, 2);
    const Knots v = random_knots(random, fibonacci(), 2, Shape::Closed, 3);
    const Grid grid = random_grid(random, u, v, 4, true);
    const SurfaceLimit coarse = surface_limit(grid, Normals::Unit);
    const SurfaceLimit fine = surface_limit(grid, refine(grid, 2, 2), Normals::Unit);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < coarse.sheet.rows; ++i)
        for (std::size_t j = 0; j < coarse.sheet.columns; ++j) {
            const auto near = [](double x) { return [x](double y) { return std::abs(x - y) < 1e-12; }; };
            const auto row = std::ranges::find_if(fine.parameters_u, near(coarse.parameters_u[i]));
            const auto column = std::ranges::find_if(fine.parameters_v, near(coarse.parameters_v[j]));
            ASSERT_TRUE(row != fine.parameters_u.end() && column != fine.parameters_v.end());
            const auto k = static_cast<std::size_t>(row - fine.parameters_u.begin()) * fine.sheet.columns +
                           static_cast<std::size_t>(column - fine.parameters_v.begin());
            for (std::size_t c = 0; c < 3; ++c, ++compared)
                EXPECT_NEAR(fine.sheet.normals[3 * k + c], coarse.sheet.normals[3 * (i * coarse.sheet.columns + j) + c],
                            4 * epsilon);
        }
    EXPECT_GE(compared, 27U);
}

} // namespace
} // namespace internode
