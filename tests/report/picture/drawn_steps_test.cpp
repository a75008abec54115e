// SPDX-License-Identifier: MIT

#include "internode/report/picture/drawn_steps.h"
#include "tests/report/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing_report::curve_of;
using testing_report::system_of;

/// Points after so many steps, without end.
std::uint64_t points_after(const Curve& curve, std::uint64_t steps) {
    return refined_size(curve, steps, std::uint64_t{1} << 40).points;
}

TEST(DrawnSteps, AreAllThatFitAndNotOneMore) {
    for (const std::string& text : {testing_report::fibonacci, testing_report::slow_growth})
        for (const Ends ends : {Ends::Open, Ends::Circular}) {
            const Curve curve = curve_of(system_of(text), 3, ends);
            for (const std::uint64_t steps : {0U, 1U, 5U, 18U, 19U, 20U, 21U, 22U, 40U, 41U, 42U, 43U, 44U, 45U, 60U}) {
                const DrawnSteps drawn = drawn_steps(curve, steps);
                EXPECT_EQ(drawn.asked, steps);
                EXPECT_LE(drawn.steps, steps);
                EXPECT_EQ(drawn.points, points_after(curve, drawn.steps));
                EXPECT_LE(drawn.points, max_drawn_points);
                if (drawn.steps < steps) {
                    EXPECT_GT(points_after(curve, drawn.steps + 1), max_drawn_points) << steps;
                }
                EXPECT_EQ(drawn_remark(drawn).empty(), drawn.steps == steps);
            }
        }
}

TEST(DrawnSteps, CountThePointsOfAllCurvesOfAPicture) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const Curve first = curve_of(system, 3, Ends::Open);
    const Curve second = curve_of(system, 2, Ends::Circular);
    const std::vector<const Curve*> curves{&first, &second, &first};
    const auto points = [&](std::uint64_t steps) {
        return 2 * points_after(first, steps) + points_after(second, steps);
    };
    for (const std::uint64_t steps : {0U, 1U, 5U, 16U, 17U, 18U, 19U, 20U, 40U}) {
        const DrawnSteps drawn = drawn_steps(curves, steps);
        EXPECT_EQ(drawn.points, points(drawn.steps));
        EXPECT_LE(drawn.points, max_drawn_points);
        EXPECT_LE(drawn.steps, drawn_steps(first, steps).steps);
        if (drawn.steps < steps) {
            EXPECT_GT(points(drawn.steps + 1), max_drawn_points) << steps;
        }
    }
    EXPECT_LT(drawn_steps(curves, 40).steps, drawn_steps(second, 40).steps);
}

TEST(DrawnSteps, GivenPointsAreDrawnHoweverMany) {
    const IntervalSystem system = system_of("A -> A A");
    CurveData data{
        .degree = 1, .ends = Ends::Circular, .word = Word(max_drawn_points + 1), .dimension = 1, .points = {}};
    data.points.assign(max_drawn_points + 1, 1.0);
    const Curve curve = make_curve(system, data).curve.value();
    EXPECT_EQ(drawn_steps(curve, 0).points, max_drawn_points + 1);
    EXPECT_EQ(drawn_remark(drawn_steps(curve, 0)), "");
    EXPECT_EQ(drawn_steps(curve, 3).steps, 0U);
}

TEST(DrawnSteps, TheRemarkSaysHowManyOfHowMany) {
    EXPECT_THAT(drawn_remark({.steps = 7, .asked = 30, .points = 5}), ::testing::HasSubstr("7 of 30 steps"));
    EXPECT_THAT(drawn_remark({.steps = 7, .asked = 30, .points = 5}),
                ::testing::HasSubstr(std::to_string(max_drawn_points) + " points"));
}

TEST(DrawnSteps, NoMoreStepsTakeNoMoreMemory) {
    const Curve curve = curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular);
    const auto bytes = [&](std::uint64_t steps) {
        return curve_picture_bytes(curve, drawn_steps(curve, steps).steps, Coordinates::Cartesian);
    };
    EXPECT_LT(bytes(5), bytes(10));
    EXPECT_EQ(bytes(40), bytes(60));
}

} // namespace
} // namespace internode
