// SPDX-License-Identifier: MIT
//
// Knots and weights on their way through the command: which symbols they become, what is written, what is refused.

#include "tests/cli/command.h"

#include "internode/io/polygon.h"
#include "internode/text/number.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::HasSubstr;

const std::string ramp = R"({"degree":2,"closed":false,"points":[[0],[1],[4],[9]],"knots":[0,0,0,1,3,3,3]})";

class Nurbs : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "subdivide");
        return here.run(arguments);
    }
    void refused(const std::vector<std::string>& arguments, const std::string& words) const {
        expect_refused(run(arguments), arguments, words);
    }
    void SetUp() override { here.file("ramp.json", ramp); }
    Workspace here;
};

/// The largest distance from radius 1 of the points x, y in a CSV, a header first; columns before x are passed over.
double worst_radius(const std::string& csv, std::size_t before) {
    const InputPolygon points = read_polygon_csv(csv, "csv").polygon.value();
    double worst = 0;
    for (std::size_t row = 0; row < points.points.size(); row += points.dimension)
        worst = std::max(worst, std::abs(std::hypot(points.points[row + before], points.points[row + before + 1]) - 1));
    return worst;
}

TEST_F(Nurbs, AGrammarOfOneSymbolTakesAnyKnots) {
    // The points are the blossoms of a function; after halving they still are: t_1 t_2 of two neighbouring knots each.
    here.file("square.json", R"({"degree":2,"closed":false,"points":[[0],[0],[3],[9]],"knots":[0,0,0,1,3,3,3]})");
    EXPECT_EQ(run({"@bisection", "square.json", "-n", "1"}).out, "x\n0\n0\n0.5\n2\n6\n9\n");
    EXPECT_EQ(run({"-e", "A -> A A", "square.json", "-n", "1"}).out, "x\n0\n0\n0.5\n2\n6\n9\n");
    const Outcome json = run({"@bisection", "ramp.json", "-n", "1", "--format", "json"});
    EXPECT_THAT(json.out, HasSubstr(R"("word": ["0", "0", "A1", "A1", "A2", "A2", "0", "0"])"));
    EXPECT_THAT(json.out, HasSubstr(R"("A2": {"value": 1, "exact": ["1"]})"));
}

TEST_F(Nurbs, OutputIsInputAgain) {
    for (const std::string file : {"ramp.json", "data/curves/circle.json"}) {
        ASSERT_EQ(run({"@bisection", file, "-n", "2", "-o", "two.json"}).code, 0);
        EXPECT_EQ(run({"@bisection", "two.json", "-n", "1"}).code, 0);
        EXPECT_EQ(run({"@bisection", "two.json", "-n", "1", "--limit", "-o", "a.csv"}).code, 0);
        EXPECT_EQ(run({"@bisection", file, "-n", "3", "--limit", "-o", "b.csv"}).code, 0);
        const InputPolygon a = read_polygon(here.read("a.csv"), "a").polygon.value();
        const InputPolygon b = read_polygon(here.read("b.csv"), "b").polygon.value();
        ASSERT_EQ(a.points.size(), b.points.size());
        for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_NEAR(a.points[i], b.points[i], 1e-14 * 8);
    }
}

TEST_F(Nurbs, AnotherGrammarMustHaveTheLengths) {
    refused({"@fibonacci", "ramp.json", "-n", "1"}, "1, 2 are not lengths of the grammar at any scale");
    const std::string grammar = "A -> A B, B -> B B B"; // ratio 3, lengths 1 and 2
    const Outcome outcome = run({"-e", grammar, "ramp.json", "-n", "1", "--format", "json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(R"("word": ["0", "0", "A", "B", "B", "B", "B", "0", "0"])"));
    here.file("golden.json", R"({"degree":1,"closed":true,"points":[[0],[1]],
        "knots":[0,{"exact":[0,1]},{"exact":["1","1"]}]})");
    EXPECT_EQ(run({"@fibonacci", "golden.json", "-n", "1"}).code, 0);
    refused({"@bisection", "golden.json", "-n", "1"}, "knot 2 has 2 coefficients, but the field has degree 1");
    here.file("even.json", R"({"degree":1,"closed":true,"points":[[0],[1]],"knots":[0,1,2]})");
    refused({"@fibonacci", "even.json", "-n", "1"}, "2 scales");
    here.file("said.json", R"({"degree":1,"closed":true,"points":[[0],[1]],"knots":[0,1,2],"lengths":{"S":1}})");
    EXPECT_EQ(run({"@fibonacci", "said.json", "-n", "1"}).out, "x\n0\n1\n");
}

TEST_F(Nurbs, KnotsLeaveNothingToSay) {
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--word", "A"}, {"--repeat"}, {"--clamped"}, {"--closed"}}) {
        std::vector<std::string> line{"@bisection", "ramp.json", "-n", "1"};
        line.insert(line.end(), more.begin(), more.end());
        EXPECT_EQ(run(line).code, 3) << more.front();
    }
    here.file("ends.json", R"({"degree":1,"points":[[0],[1]],"knots":[0,1,3]})");
    refused({"@bisection", "ends.json", "-n", "1"}, "needs 4 knots, or 2 without the first and the last, not 3");
    EXPECT_EQ(run({"@bisection", "ends.json", "-n", "1", "--closed"}).code, 0);
    here.file("axiom.lsys", "intervals g\nA -> A A\nB -> B B\naxiom 0 0 B A 0 0\nlength A = 1\nlength B = 2\n");
    refused({"axiom.lsys", "ramp.json", "-n", "1"}, "the grammar's axiom (6 letters) disagree");
    here.file("axiom.lsys", "intervals g\nA -> A A\nB -> B B\naxiom 0 0 A B 0 0\nlength A = 1\nlength B = 2\n");
    EXPECT_EQ(run({"axiom.lsys", "ramp.json", "-n", "1"}).code, 0);
}

TEST_F(Nurbs, TheCircleStaysACircleThroughTenSteps) {
    const Outcome limit = run({"@bisection", "data/curves/circle.json", "-n", "10", "--limit"});
    ASSERT_EQ(limit.code, 0) << limit.err;
    EXPECT_LE(worst_radius(limit.out, 1), 1e-13);
    EXPECT_EQ(std::ranges::count(limit.out, '\n'), 4 * 1024 + 2);
}

TEST_F(Nurbs, WeightsAreALastColumnWhereThereIsRoom) {
    const Outcome csv = run({"@bisection", "data/curves/circle.json", "-n", "1", "-o", "one.csv"});
    ASSERT_EQ(csv.code, 0) << csv.err;
    EXPECT_THAT(here.read("one.csv"), testing::StartsWith("x,y,w\n1,0,1\n1,0.414213562373095"));
    const std::string word = "0 0 A A 0 A A 0 A A 0 A A 0 0";
    EXPECT_EQ(run({"@bisection", "one.csv", "--rational", "-d", "2", "--word", word, "-n", "0"}).out.substr(0, 6),
              "x,y,w\n");
    const Outcome again = run({"@bisection", "one.csv", "--rational", "-d", "2", "--word", word, "-n", "3", "--limit"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_LE(worst_radius(again.out, 1), 1e-13);
    const Outcome obj = run({"@bisection", "data/curves/circle.json", "-n", "1", "--format", "obj"});
    EXPECT_THAT(obj.out, HasSubstr("v 1 0.41421356237309"));
    EXPECT_THAT(run({"@bisection", "data/curves/circle.json", "-n", "1", "--format", "json"}).out,
                HasSubstr("\"weights\": [1, 0.8535533905932737, "));
    EXPECT_THAT(run({"@bisection", "data/curves/circle.json", "-n", "1", "--format", "svg"}).out,
                HasSubstr("<g id=\"limit\""));
    EXPECT_THAT(run({"@bisection", "data/curves/circle.json", "-n", "1", "--plan"}).out, HasSubstr("points 13\n"));
}

TEST_F(Nurbs, RefusesWeightsThatDoNotFit) {
    refused({"@bisection", "data/curves/circle.json", "--rational", "-n", "1"}, "weights of its own");
    refused({"@bisection", "ramp.json", "--rational", "-n", "1"}, "have one number");
    here.file("zero.csv", "x,w\n0,1\n1,0\n");
    refused({"@bisection", "zero.csv", "--rational", "-d", "1", "--word", "(A A)", "-n", "1"},
            "the weight of point 2 of zero.csv is 0");
    here.file("graph.csv", "x,w\n0,1\n1,2\n");
    refused({"@bisection", "graph.csv", "--rational", "-d", "1", "--word", "(A A)", "-n", "1", "--format", "svg"},
            "has no picture");
    refused({"@bisection", "data/curves/circle.json", "-n", "1", "--limit", "--derivatives"}, "are not computed");
    const Outcome converge = here.run({"converge", "@bisection", "data/curves/circle.json", "-n", "2"});
    EXPECT_EQ(converge.code, 3);
    EXPECT_THAT(converge.err, HasSubstr("have weights"));
}

TEST_F(Nurbs, SymbolsOfAFileAreNamedLikeThoseOfAGrammar) {
    here.file("evil.json", R"({"degree":1,"closed":true,"points":[[0],[1]],"word":["<a","<a"],"lengths":{"<a":1}})");
    refused({"@bisection", "evil.json", "-n", "1"}, "no symbol of the grammar");
    here.file("field.json", R"({"degree":1,"closed":true,"points":[[0],[1]],"word":["B","B"],
        "lengths":{"B":{"exact":[1,2]}}})");
    refused({"@bisection", "field.json", "-n", "1"}, "must be a positive rational");
    here.file("part.json", R"({"degree":1,"closed":true,"points":[[0],[1]],"word":["B","C"],"lengths":{"B":1}})");
    refused({"@bisection", "part.json", "-n", "1"}, "`C` is no symbol");
}

const std::string curves_and_lines = "v 0 0 0\nv 1 0 0\nv 1 1 0\ncstype bspline\ndeg 1\n"
                                     "curv 0 1 1 2\nparm u 0 0 1 1\nend\ncurv 0 3 1 2 3\nparm u 0 0 1 3 3\nend\n";

TEST_F(Nurbs, ObjFilesAreCurvesWithKnots) {
    const Outcome limit = run({"@bisection", "data/curves/circle.obj", "-n", "10", "--limit"});
    ASSERT_EQ(limit.code, 0) << limit.err;
    EXPECT_LE(worst_radius(limit.out, 1), 1e-13);
    here.file("lines.obj", curves_and_lines);
    EXPECT_EQ(run({"@bisection", "lines.obj", "--element", "2", "-n", "0"}).out, "x,y,z\n0,0,0\n1,0,0\n1,1,0\n");
    EXPECT_EQ(here.run({"subdivide", "@bisection", "-", "--element", "1", "-n", "1"}, curves_and_lines).out,
              "x,y,z\n0,0,0\n0.5,0,0\n1,0,0\n");
    EXPECT_EQ(here.run({"converge", "@bisection", "lines.obj", "--element", "1", "-n", "1"}).code, 0);
    EXPECT_EQ(run({"@bisection", "lines.obj", "--element", "1", "-d", "2", "-n", "1"}).code, 3);
}

TEST_F(Nurbs, RefusesObjFilesWithTheirLines) {
    here.file("lines.obj", curves_and_lines);
    refused({"@bisection", "lines.obj", "--element", "3", "-n", "1"}, "no element 3");
    refused({"@bisection", "lines.obj", "--element", "0", "-n", "1"}, "no element 0");
    refused({"@bisection", "ramp.json", "--element", "2", "-n", "1"}, "no element 2: ramp.json has 1");
    refused({"@fibonacci", "lines.obj", "--element", "2", "-n", "1"}, "not lengths of the grammar");
    for (const std::string index : {"0", "-4", "4", "2147483648", "9223372036854775808"}) {
        here.file("index.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\ncstype bspline\ndeg 1\ncurv 0 1 1 " + index + "\n");
        refused({"@bisection", "index.obj", "-n", "1"}, "index.obj:6:12: error: no vertex " + index);
    }
    here.file("empty.obj", "");
    refused({"@bisection", "empty.obj", "-n", "1"}, "no curve or surface of free form");
    here.file("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"
                          "parm u 0 0 1 1\nparm v 0 0 1 1\nend\n");
    refused({"@bisection", "flat.obj", "-n", "1"}, "element 1 of flat.obj (line 7) is a surface");
}

/// How far the vertices of an OBJ lie from the torus of radii 2 and 1.
double worst_tube(const std::string& obj) {
    double worst = 0;
    for (std::size_t at = 0; at < obj.size(); at = obj.find('\n', at) + 1) {
        if (obj.compare(at, 2, "v ") != 0) continue;
        double x[3] = {};
        for (double& coordinate : x) {
            at = obj.find(' ', at) + 1;
            coordinate = parse_double(obj.substr(at, obj.find_first_of(" \n", at) - at)).value();
        }
        worst = std::max(worst, std::abs(std::hypot(std::hypot(x[0], x[1]) - 2, x[2]) - 1));
    }
    return worst;
}

TEST_F(Nurbs, TheTorusStaysATorus) {
    for (const std::string file : {"data/grids/torus.json", "data/grids/torus.obj"}) {
        const std::vector<std::string> job{"--u", "@bisection", "--v", "@bisection", file, "-n", "4"};
        std::vector<std::string> limit = job;
        limit.insert(limit.end(), {"--limit", "--format", "obj"});
        const Outcome outcome = run(limit);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_LE(worst_tube(outcome.out), 1e-13);
        std::vector<std::string> saved = job;
        saved.insert(saved.end(), {"-o", "four.json"});
        ASSERT_EQ(run(saved).code, 0);
        const Outcome again =
            run({"--u", "@bisection", "--v", "@trisection", "four.json", "-n", "1", "--limit", "--format", "obj"});
        ASSERT_EQ(again.code, 0) << again.err;
        EXPECT_LE(worst_tube(again.out), 1e-13);
    }
}

TEST_F(Nurbs, RefusesGridsWhoseKnotsDoNotFit) {
    const auto grid = [](const std::string& file, const std::vector<std::string>& more) {
        std::vector<std::string> line{"--u", "@bisection", "--v", "@bisection", file, "-n", "1"};
        line.insert(line.end(), more.begin(), more.end());
        return line;
    };
    refused(grid("data/grids/torus.json", {"--word-u", "A"}), "along u leave nothing to --word-u");
    refused(grid("data/grids/torus.json", {"--element", "1"}), "no OBJ file");
    refused(grid("data/curves/circle.obj", {}), "is a curve");
    here.file("short.json", R"({"degree":[1,1],"points":[[[0],[1]],[[2],[3]]],"knots":[[0,0,1,1],[0,2,1]]})");
    refused(grid("short.json", {}), "along v: an open curve of degree 1 with 2 points needs 4 knots");
    refused({"--u", "@fibonacci", "--v", "@bisection", "data/grids/torus.json", "-n", "1"}, "along u: ");
}

} // namespace
} // namespace internode::tests
