// SPDX-License-Identifier: MIT

#include "internode/report/picture/curve_picture.h"
#include "internode/report/picture/palette.h"
#include "tests/report/picture/drawn_points.h"
#include "tests/report/picture/planar.h"
#include "tests/report/systems.h"

namespace internode {
namespace {

using testing_report::curve_of;
using testing_report::dots_of;
using testing_report::expect_drawn;
using testing_report::expect_near;
using testing_report::planar_of;
using testing_report::system_of;
using testing_report::way_of;
using testing_report::WayToScreen;
using tests::DrawnShape;
using tests::Spot;

std::vector<DrawnShape> drawn(const PlanarCurve& planar) {
    return tests::shapes_of(tests::read_markup(curve_picture(planar, {.title = "t", .generator = {"0", "x"}})));
}

/// The vertices of the polygon in this layer, in their order.
std::vector<Spot> polygon_of(const std::vector<DrawnShape>& shapes, std::string_view layer, bool closed) {
    const std::vector<DrawnShape> some = shapes_in(shapes, layer);
    EXPECT_EQ(some.at(0).runs.size(), 1U);
    EXPECT_EQ(some.at(0).runs.at(0).closed, closed);
    return some.at(0).runs.at(0).points;
}

/// The pieces of a path in their order, each `commands` commands of `each` points, its start in front.
std::vector<std::vector<Spot>> pieces_of(const DrawnShape& path, std::size_t each) {
    std::vector<std::vector<Spot>> pieces;
    for (const tests::Run& run : path.runs)
        for (std::size_t at = 0; at + each < run.points.size(); at += each)
            pieces.emplace_back(run.points.begin() + static_cast<std::ptrdiff_t>(at),
                                run.points.begin() + static_cast<std::ptrdiff_t>(at + each + 1));
    return pieces;
}

/// A Bézier curve at t, by Bernstein's polynomials.
Point2 bernstein(std::span<const Point2> points, double t) {
    const std::size_t degree = points.size() - 1;
    Point2 sum;
    double choose = 1;
    for (std::size_t b = 0; b <= degree; ++b) {
        const double weight =
            choose * std::pow(t, static_cast<double>(b)) * std::pow(1 - t, static_cast<double>(degree - b));
        sum = {.x = sum.x + weight * points[b].x, .y = sum.y + weight * points[b].y};
        choose = choose * static_cast<double>(degree - b) / static_cast<double>(b + 1);
    }
    return sum;
}

/// Symbols with pieces, each with those pieces' numbers.
std::vector<std::vector<std::size_t>> pieces_by_symbol(const PlanarCurve& planar) {
    std::vector<std::vector<std::size_t>> pieces(planar.names.size());
    for (std::size_t k = 0; k < planar.symbols.size(); ++k) pieces[to_index(planar.symbols[k])].push_back(k);
    return pieces;
}

void expect_look(const DrawnShape& path, Symbol symbol) {
    EXPECT_EQ(path.attribute("stroke"), symbol_style(symbol).colour);
    EXPECT_EQ(path.attribute("stroke-dasharray"), symbol_style(symbol).dashes);
}

TEST(CurveDrawing, PiecesAreTheBezierSegmentsInTheColourAndDashesOfTheirSymbol) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    std::size_t compared = 0;
    for (int degree = 1; degree <= 3; ++degree)
        for (const Ends ends : {Ends::Open, Ends::Circular}) {
            const PlanarCurve planar = planar_of(curve_of(system, degree, ends), 2);
            const std::vector<DrawnShape> shapes = drawn(planar);
            const WayToScreen way = way_of(planar.control, polygon_of(shapes, "control", planar.closed));
            EXPECT_NEAR(way.right, way.up, 0.01);
            const std::vector<DrawnShape> limit = shapes_in(shapes, "limit");
            ASSERT_EQ(limit.size(), 2U);
            const auto size = static_cast<std::size_t>(degree) + 1;
            for (std::size_t i = 0; i < 2; ++i) {
                expect_look(limit[i], to_symbol(i));
                const auto drawn_pieces = pieces_of(limit[i], size - 1);
                const std::vector<std::size_t> own = pieces_by_symbol(planar)[i];
                ASSERT_EQ(drawn_pieces.size(), own.size());
                for (std::size_t k = 0; k < own.size(); ++k, ++compared) {
                    const auto begin = planar.segments.begin() + static_cast<std::ptrdiff_t>(own[k] * size);
                    expect_drawn({begin, begin + static_cast<std::ptrdiff_t>(size)}, drawn_pieces[k], way);
                }
            }
        }
    EXPECT_GT(compared, 90U);
}

TEST(CurveDrawing, PiecesOfHigherDegreeArePointsOfTheCurveInOrder) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const PlanarCurve planar = planar_of(curve_of(system, 5, Ends::Circular), 1);
    const std::vector<DrawnShape> shapes = drawn(planar);
    const WayToScreen way = way_of(planar.control, polygon_of(shapes, "control", true));
    constexpr std::size_t chords = 16;
    const std::vector<DrawnShape> limit = shapes_in(shapes, "limit");
    ASSERT_EQ(limit.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto drawn_pieces = pieces_of(limit[i], chords);
        const std::vector<std::size_t> own = pieces_by_symbol(planar)[i];
        ASSERT_EQ(drawn_pieces.size(), own.size());
        for (std::size_t k = 0; k < own.size(); ++k)
            for (std::size_t chord = 0; chord <= chords; ++chord)
                expect_near(drawn_pieces[k][chord], way(bernstein(std::span(planar.segments).subspan(6 * own[k], 6),
                                                                  static_cast<double>(chord) / chords)));
    }
}

/// A quarter of a circle, exactly: all points of the drawing are at one distance from its centre.
TEST(CurveDrawing, RationalPiecesAreDividedByTheirWeights) {
    PlanarCurve arc;
    arc.degree = 2;
    arc.names = {"A"};
    arc.symbols = {to_symbol(0)};
    arc.segments = {{1, 0}, {1, 1}, {0, 1}};
    arc.weights = {1, std::sqrt(0.5), 1};
    arc.control = {{1, 0}, {1, 1}, {0, 1}};
    const std::vector<DrawnShape> shapes = drawn(arc);
    const WayToScreen way = way_of(arc.control, polygon_of(shapes, "control", false));
    const std::vector<Spot> spots = shapes_in(shapes, "limit").at(0).runs.at(0).points;
    EXPECT_EQ(spots.size(), 65U);
    for (const Spot& spot : spots) {
        const double x = (spot.x - way.x) / way.right;
        const double y = (way.y - spot.y) / way.up;
        EXPECT_NEAR(x * x + y * y, 1, 2e-4);
    }
}

TEST(CurveDrawing, PolygonsAndKnotsLieOnTheSameWay) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    for (const Ends ends : {Ends::Open, Ends::Circular}) {
        const PlanarCurve planar = planar_of(curve_of(system, 3, ends), 1);
        const std::vector<DrawnShape> shapes = drawn(planar);
        const WayToScreen way = way_of(planar.control, polygon_of(shapes, "control", planar.closed));
        expect_drawn(planar.control, polygon_of(shapes, "control", planar.closed), way);
        expect_drawn(planar.control, dots_of(shapes_in(shapes, "control").at(1)), way);
        expect_drawn(planar.refined, polygon_of(shapes, "refined", planar.closed), way);
        std::vector<Point2> knots;
        for (std::size_t k = 0; k < planar.symbols.size(); ++k) knots.push_back(planar.segments[4 * k]);
        if (!planar.closed) knots.push_back(planar.segments.back());
        for (const DrawnShape& marks : shapes_in(shapes, "knots")) expect_drawn(knots, dots_of(marks), way);
    }
}

TEST(CurveDrawing, AGraphHasAScaleForEachDirectionAndIsUpright) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const PlanarCurve planar = planar_of(curve_of(system, 2, Ends::Open, 1), 1);
    const std::vector<DrawnShape> shapes = drawn(planar);
    const std::vector<Spot> control = polygon_of(shapes, "control", false);
    const WayToScreen way = way_of(planar.control, control);
    expect_drawn(planar.control, control, way);
    for (const DrawnShape& path : shapes_in(shapes, "limit"))
        for (const tests::Run& run : path.runs)
            for (const Spot& spot : run.points) {
                EXPECT_TRUE(28 <= spot.x + 0.01 && spot.x <= 932.01);
                EXPECT_TRUE(58 <= spot.y + 0.01 && spot.y <= 478.01);
            }
}

TEST(CurveDrawing, SamplesOfTheLegendLookLikeTheirPieces) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const std::vector<DrawnShape> legend =
        shapes_in(drawn(planar_of(curve_of(system, 3, Ends::Circular), 1)), "legend");
    ASSERT_EQ(legend.size(), 6U) << "two symbols and the control polygon, each a sample and a text";
    for (std::size_t i = 0; i < 2; ++i) {
        expect_look(legend[2 * i], to_symbol(i));
        EXPECT_EQ(legend[2 * i + 1].text.substr(0, 1), system.alphabet().name(to_symbol(i)));
        EXPECT_GT(legend[2 * i + 1].at.x, legend[2 * i].runs[0].points.back().x);
    }
}

TEST(CurveDrawing, ARemarkIsALineBelowTheLegend) {
    const PlanarCurve planar = planar_of(curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular), 1);
    const CurvePictureOptions plain{.title = "t", .generator = {"0", "x"}};
    CurvePictureOptions remarked = plain;
    remarked.remark = "a <remark>";
    const tests::Element without = tests::read_markup(curve_picture(planar, plain));
    const tests::Element with = tests::read_markup(curve_picture(planar, remarked));
    const DrawnShape last = tests::shapes_of(with).back();
    EXPECT_EQ(last.text, "a <remark>");
    EXPECT_GT(with.number("height"), without.number("height"));
    EXPECT_GE(last.at.y, without.number("height"));
    EXPECT_LT(last.at.y, with.number("height"));
}

/// A copy of the curve elsewhere, its symbols under other names and in another order where asked.
PlanarCurve moved(PlanarCurve curve, double right, double up, const std::vector<std::string>& names) {
    for (std::vector<Point2>* points : {&curve.control, &curve.refined, &curve.segments})
        for (Point2& point : *points) point = {.x = point.x + right, .y = point.y + up};
    curve.names = names;
    return curve;
}

std::vector<Spot> all_spots(const std::vector<DrawnShape>& shapes) {
    std::vector<Spot> spots;
    for (const DrawnShape& shape : shapes)
        for (const tests::Run& run : shape.runs) spots.insert(spots.end(), run.points.begin(), run.points.end());
    return spots;
}

TEST(CurveDrawing, SeveralCurvesStandInOneFrameLayerByLayer) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    for (const Ends ends : {Ends::Open, Ends::Circular}) {
        const PlanarCurve one = planar_of(curve_of(system, 3, ends), 2);
        const std::vector<PlanarCurve> curves{one, moved(one, 20, -3, one.names), moved(one, 4, 30, {"S", "T"})};
        StringSink sink;
        write_curve_picture(sink, curves, {.title = "t", .generator = {"0", "x"}});
        const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(sink.text()));
        std::vector<Point2> control;
        std::vector<Point2> refined;
        for (const PlanarCurve& curve : curves) {
            control.insert(control.end(), curve.control.begin(), curve.control.end());
            refined.insert(refined.end(), curve.refined.begin(), curve.refined.end());
        }
        const WayToScreen way = way_of(control, all_spots({shapes_in(shapes, "control").at(0)}));
        expect_drawn(control, all_spots({shapes_in(shapes, "control").at(0)}), way);
        expect_drawn(refined, all_spots({shapes_in(shapes, "refined").at(0)}), way);
        const std::vector<DrawnShape> limit = shapes_in(shapes, "limit");
        ASSERT_EQ(limit.size(), 3U) << "L, S and T: a path for each name";
        const std::vector<std::vector<std::pair<std::size_t, std::size_t>>> owners{
            {{0, 0}, {1, 0}}, {{0, 1}, {1, 1}, {2, 0}}, {{2, 1}}}; // curve and symbol there
        for (std::size_t i = 0; i < 3; ++i) {
            expect_look(limit[i], to_symbol(i));
            const auto drawn_pieces = pieces_of(limit[i], 3);
            std::size_t at = 0;
            for (const auto& [curve, symbol] : owners[i]) {
                const std::vector<std::size_t> own = pieces_by_symbol(curves[curve])[symbol];
                for (const std::size_t piece : own) {
                    ASSERT_LT(at, drawn_pieces.size());
                    const auto begin = curves[curve].segments.begin() + static_cast<std::ptrdiff_t>(4 * piece);
                    expect_drawn({begin, begin + 4}, drawn_pieces[at++], way);
                }
            }
            EXPECT_EQ(at, drawn_pieces.size());
        }
        for (const std::string layer : {"control", "refined", "limit", "knots"})
            for (const Spot& spot : all_spots(shapes_in(shapes, layer))) {
                EXPECT_TRUE(28 <= spot.x + 0.01 && spot.x <= 932.01) << layer;
                EXPECT_TRUE(58 <= spot.y + 0.01 && spot.y <= 778.01) << layer;
            }
        EXPECT_EQ(shapes_in(shapes, "legend").size(), 8U);
    }
}

TEST(CurveDrawing, RefusesNoCurveAndFunctionsBesideCurvesOfThePlane) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    StringSink sink;
    EXPECT_THROW(write_curve_picture(sink, {}, {.title = "t", .generator = {}}), std::invalid_argument);
    const std::vector<PlanarCurve> mixed{planar_of(curve_of(system, 2, Ends::Open, 1), 1),
                                         planar_of(curve_of(system, 2, Ends::Open), 1)};
    EXPECT_THROW(write_curve_picture(sink, mixed, {.title = "t", .generator = {}}), std::invalid_argument);
    EXPECT_EQ(sink.text(), "");
}

} // namespace
} // namespace internode
