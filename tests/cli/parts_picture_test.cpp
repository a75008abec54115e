// SPDX-License-Identifier: MIT
//
// The picture of several polygons of a file, read back as a drawing: all of them stand in one frame, each where its
// coordinates say.

#include "tests/cli/command.h"
#include "tests/report/picture/drawn_points.h"

#include "internode/text/number.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;
using testing_report::dots_of;
using testing_report::expect_drawn;
using testing_report::way_of;
using testing_report::WayToScreen;

using Points = std::vector<Point2>;

/// Two columns of a CSV, a list for each part.
std::vector<Points> parts_of(const std::string& csv, std::size_t first_column = 0) {
    std::vector<Points> parts(1);
    std::istringstream stream(csv);
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        if (line.empty()) {
            parts.emplace_back();
            continue;
        }
        std::vector<double> row;
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) row.push_back(parse_double(field).value());
        parts.back().push_back({.x = row.at(first_column), .y = row.at(first_column + 1)});
    }
    return parts;
}

Points all_of(const std::vector<Points>& parts) {
    Points all;
    for (const Points& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::vector<Spot> spots_of(const DrawnShape& path) {
    std::vector<Spot> spots;
    for (const Run& run : path.runs) spots.insert(spots.end(), run.points.begin(), run.points.end());
    return spots;
}

/// A run for each part, along one way, closed or not.
void expect_runs(const std::vector<Points>& parts, const DrawnShape& path, bool closed, const WayToScreen& way) {
    ASSERT_EQ(path.runs.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_EQ(path.runs[i].closed, closed);
        expect_drawn(parts[i], path.runs[i].points, way);
    }
}

class PartsPicture : public testing::Test {
protected:
    void SetUp() override {
        here.file("three.csv", "x,y\n0,0\n4,0\n4,3\n0,3\n\n9,1\n12,1\n13,4\n12,6\n8,3\n\n0,9\n3,8\n6,9\n7,11\n6,14\n3,"
                               "15\n");
    }
    std::string out(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "subdivide");
        const Outcome outcome = here.run(arguments);
        EXPECT_EQ(outcome.code, 0) << testing::PrintToString(arguments) << outcome.err;
        return outcome.out;
    }
    std::vector<DrawnShape> picture(std::vector<std::string> arguments) const {
        arguments.emplace_back("--svg");
        return shapes_of(read_markup(out(arguments)));
    }
    Workspace here;
};

TEST_F(PartsPicture, OfAPointGrammarHasAllPartsInEveryPanelInOneScale) {
    std::size_t compared = 0;
    for (const auto& [name, closed] : std::vector<std::pair<std::string, bool>>{
             {"@s0/13", true}, {"@four-point", true}, {"@midpoint-displacement", true}, {"@s0/34-36", false}}) {
        const std::vector<DrawnShape> shapes = picture({name, "three.csv", "-n", "2"});
        WayToScreen first;
        for (std::size_t level = 0; level <= 2; ++level) {
            const std::vector<Points> parts = parts_of(out({name, "three.csv", "-n", std::to_string(level)}));
            ASSERT_EQ(parts.size(), 3U);
            const std::vector<DrawnShape> panel = shapes_in(shapes, "level-" + std::to_string(level));
            const auto lines = std::ranges::find_if(
                panel, [](const DrawnShape& shape) { return shape.name == "path" && !shape.used; });
            ASSERT_NE(lines, panel.end());
            const WayToScreen way = way_of(all_of(parts), spots_of(*lines));
            EXPECT_NEAR(way.right, way.up, 0.01);
            if (level == 0) first = way;
            EXPECT_NEAR(way.right, first.right, 0.01) << "one scale in all panels";
            expect_runs(parts, *lines, closed, way);
            expect_drawn(all_of(parts), dots_of(*(lines + 1)), way);
            const DrawnShape& caption = panel.back();
            EXPECT_EQ(caption.text, "level " + std::to_string(level) + ": " + std::to_string(all_of(parts).size()) +
                                        " points in 3 parts");
            const double width = 2 * (caption.at.x - lines->at.x);
            for (const Spot& spot : spots_of(*lines)) {
                EXPECT_TRUE(lines->at.x < spot.x && spot.x < lines->at.x + width);
                EXPECT_TRUE(lines->at.y < spot.y && spot.y < caption.at.y - 16);
                ++compared;
            }
            if (level > 0) {
                ASSERT_TRUE(panel.front().used) << "the control polygons lie under every level";
                EXPECT_EQ(panel.front().runs.size(), 3U);
            }
        }
    }
    EXPECT_GT(compared, 4 * (15 + 20 + 30U));
}

TEST_F(PartsPicture, OfCurvesHasAllPartsInOneFrame) {
    const std::vector<Points> control = parts_of(here.read("three.csv"));
    for (const bool closed : {true, false})
        for (const char* degree : {"1", "2", "3", "5"}) {
            if (!closed && degree[0] == '5') continue; // four points are too few
            std::vector<std::string> job{
                "@fibonacci", "three.csv",         "-d",       degree, closed ? "--closed" : "--clamped",
                "--word",     closed ? "LS" : "L", "--repeat", "-n",   "2"};
            const std::vector<DrawnShape> shapes = picture(job);
            const std::vector<DrawnShape> polygons = shapes_in(shapes, "control");
            const WayToScreen way = way_of(all_of(control), spots_of(polygons.at(0)));
            EXPECT_NEAR(way.right, way.up, 0.01);
            expect_runs(control, polygons.at(0), closed, way);
            expect_drawn(all_of(control), dots_of(polygons.at(1)), way);
            const std::vector<Points> refined = parts_of(out(job));
            expect_runs(refined, shapes_in(shapes, "refined").at(0), closed, way);
            job.emplace_back("--limit");
            const Points knots = all_of(parts_of(out(job), 1));
            for (const DrawnShape& marks : shapes_in(shapes, "knots")) expect_drawn(knots, dots_of(marks), way);
            for (const DrawnShape& path : shapes_in(shapes, "limit"))
                for (const Spot& spot : spots_of(path)) {
                    EXPECT_TRUE(28 <= spot.x + 0.01 && spot.x <= 932.01);
                    EXPECT_TRUE(58 <= spot.y + 0.01 && spot.y <= 58 + 720 + 0.01);
                }
        }
}

/// The letters of three words under their names, and as many as there are.
TEST_F(PartsPicture, CountsTheIntervalsOfAllCurvesByTheirSymbols) {
    const std::vector<std::string> job{"@fibonacci", "three.csv", "-d",       "2",  "--closed",
                                       "--word",     "LS",        "--repeat", "-n", "0"};
    const std::vector<DrawnShape> legend = shapes_in(picture(job), "legend");
    ASSERT_EQ(legend.size(), 6U);
    EXPECT_EQ(legend[1].text, "L × 8"); // LSLS, LSLSL, LSLSLS
    EXPECT_EQ(legend[3].text, "S × 7");
}

TEST_F(PartsPicture, OfNumbersIsOneGraph) {
    here.file("numbers.csv", "0\n3\n1\n\n8\n-5\n2\n4\n");
    const std::vector<DrawnShape> levels = picture({"@s0/34-36", "numbers.csv", "-n", "0"});
    const DrawnShape lines = shapes_in(levels, "level-0").at(0);
    ASSERT_EQ(lines.runs.size(), 2U);
    const std::vector<Points> parts{{{0, 0}, {0.5, 3}, {1, 1}}, {{0, 8}, {1 / 3.0, -5}, {2 / 3.0, 2}, {1, 4}}};
    expect_runs(parts, lines, false, way_of(all_of(parts), spots_of(lines)));
    const std::vector<DrawnShape> curves =
        picture({"@bisection", "numbers.csv", "-d", "1", "--clamped", "--word", "A", "--repeat", "-n", "1"});
    const DrawnShape control = shapes_in(curves, "control").at(0);
    const std::vector<Points> graphs{{{0, 0}, {1, 3}, {2, 1}}, {{0, 8}, {1, -5}, {2, 2}, {3, 4}}};
    expect_runs(graphs, control, false, way_of(all_of(graphs), spots_of(control)));
}

TEST_F(PartsPicture, RefusesNumbersBesidePoints) {
    here.file("mixed.json", R"({"format": "internode-curves", "curves": [)"
                            R"({"points": [[0], [1]]}, {"points": [[0, 0], [1, 2]]}]})");
    for (const std::vector<std::string>& job :
         {std::vector<std::string>{"@s0/13", "mixed.json", "-n", "1", "--svg"},
          {"@bisection", "mixed.json", "-d", "1", "--closed", "--word", "A", "--repeat", "-n", "1", "--svg"}}) {
        std::vector<std::string> arguments = job;
        arguments.insert(arguments.begin(), "subdivide");
        const Outcome outcome = here.run(arguments);
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("polygons of one coordinate and of more have no picture together"));
    }
}

TEST_F(PartsPicture, TakesTheAxesThatAllPartsHave) {
    here.file("mixed.json", R"({"format": "internode-curves", "curves": [)"
                            R"({"points": [[0, 5, 1], [1, 6, 3]]}, {"points": [[0, 0], [1, 2]]}]})");
    for (const std::vector<std::string>& grammar :
         {std::vector<std::string>{"@s0/13"}, {"@bisection", "-d", "1", "--closed", "--word", "A", "--repeat"}}) {
        std::vector<std::string> arguments = grammar;
        arguments.insert(arguments.end(), {"mixed.json", "-n", "0"});
        const std::vector<DrawnShape> shapes = picture(arguments);
        const std::vector<Points> parts{{{0, 5}, {1, 6}}, {{0, 0}, {1, 2}}};
        const DrawnShape lines = shapes_in(shapes, grammar.size() == 1 ? "level-0" : "control").at(0);
        expect_runs(parts, lines, true, way_of(all_of(parts), spots_of(lines)));
        arguments.insert(arguments.begin(), "subdivide");
        arguments.insert(arguments.end(), {"--svg", "--axes", "1,3"});
        EXPECT_EQ(here.run(arguments).code, 2) << "no third coordinate in the second";
    }
}

} // namespace
} // namespace internode::tests
