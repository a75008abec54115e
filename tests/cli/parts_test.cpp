// SPDX-License-Identifier: MIT
//
// Several polygons in one file, and parameters that are the file's, on their way through the command.

#include "tests/cli/command.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Parts : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"subdivide", "@bisection"});
        return here.run(arguments);
    }
    void refused(const std::vector<std::string>& arguments, const std::string& words) const {
        expect_refused(run(arguments), arguments, words);
    }
    void SetUp() override {
        here.file("two.csv", "x,y\n0,0\n2,0\n\n0,4\n2,4\n4,4\n");
        here.file("gmt.csv", "> a\n0,0\n2,0\n> b\n0,4\n2,4\n");
    }
    std::vector<std::string> lines(const std::string& file, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{file, "-d", "1", "--clamped", "--word", "A", "--repeat", "-n", "1"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Workspace here;
};

TEST_F(Parts, OfACsvAreRefinedEach) {
    EXPECT_EQ(run(lines("two.csv")).out, "x,y\n0,0\n1,0\n2,0\n\n0,4\n1,4\n2,4\n3,4\n4,4\n");
    EXPECT_EQ(run(lines("gmt.csv")).out, "x,y\n> a\n0,0\n1,0\n2,0\n> b\n0,4\n1,4\n2,4\n");
    EXPECT_EQ(run(lines("two.csv", {"--limit"})).out,
              "t,x,y\n0,0,0\n0.5,1,0\n1,2,0\n\n0,0,4\n0.5,1,4\n1,2,4\n1.5,3,4\n2,4,4\n");
    EXPECT_EQ(run(lines("two.csv", {"--element", "2"})).out, "x,y\n0,4\n1,4\n2,4\n3,4\n4,4\n");
}

TEST_F(Parts, AreOneAfterAnotherInObj) {
    EXPECT_EQ(here.shell("$INTERNODE subdivide @bisection two.csv -d 1 --clamped --word A --repeat -n 0 -o two.obj; "
                         "grep -v '^#' two.obj")
                  .out,
              "v 0 0 0\nv 2 0 0\nl 1 2\nv 0 4 0\nv 2 4 0\nv 4 4 0\nl 3 4 5\n");
    EXPECT_EQ(run(lines("two.obj")).out, "x,y,z\n0,0,0\n1,0,0\n2,0,0\n\n0,4,0\n1,4,0\n2,4,0\n3,4,0\n4,4,0\n");
    EXPECT_EQ(run(lines("two.csv", {"--limit", "--format", "obj"})).out,
              "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2 3\nv 0 4 0\nv 1 4 0\nv 2 4 0\nv 3 4 0\nv 4 4 0\nl 4 5 6 7 8\n");
}

TEST_F(Parts, AreAListInJsonThatIsReadBack) {
    ASSERT_EQ(run(lines("two.csv", {"-o", "two.json"})).code, 0);
    EXPECT_THAT(here.read("two.json"), HasSubstr("\"format\": \"internode-curves\""));
    EXPECT_EQ(run({"two.json", "-n", "0"}).out, run(lines("two.csv")).out);
    EXPECT_EQ(run({"two.json", "-n", "0", "--element", "1"}).out, "x,y\n0,0\n1,0\n2,0\n");
}

TEST_F(Parts, OfTooFewPointsAreRefusedWithTheirLine) {
    here.file("short.csv", "0,0\n1,0\n2,0\n3,0\n\n# here\n5,5\n6,6\n");
    refused({"short.csv", "-d", "3", "--word", "A", "--repeat", "-n", "1"},
            "short.csv:7: error: an open curve of degree 3 needs at least 4 points, not 2");
    here.file("empty.csv", "0,0\n1,0\n> nothing\n");
    refused(lines("empty.csv"), "empty.csv:3:1: error: no point follows in this part");
}

TEST_F(Parts, AreRefusedWhereOneCurveIsMeant) {
    refused(lines("two.csv", {"--format", "npy"}), "npy holds one polygon, the file has 2");
    refused(lines("two.csv", {"--element", "3"}), "no element 3: two.csv has 2");
    const Outcome converge =
        here.run({"converge", "@bisection", "two.csv", "-d", "1", "--word", "A", "--repeat", "-n", "1"});
    EXPECT_EQ(converge.code, 3);
    EXPECT_THAT(converge.err, AllOf(HasSubstr("two.csv has 2 polygons"), HasSubstr("--element 1 … 2")));
    EXPECT_EQ(here.run({"reverse", "@bisection", "two.csv", "-d", "1", "--word", "A", "--repeat", "-n", "1"}).code, 3);
}

TEST_F(Parts, OfSeveralDimensionsAreNoTable) {
    here.file("mixed.json", R"({"format": "internode-curves", "curves": [{"points": [[0], [1]]},)"
                            R"( {"points": [[0, 0], [1, 2]]}, {"points": [[0], [1]], "weights": [1, 2]}]})");
    refused(lines("mixed.json"), "one polygon has 1 columns, another 2");
    refused(lines("mixed.json", {"--limit"}), "one polygon has 1 columns, another 2");
    EXPECT_EQ(run(lines("mixed.json", {"--json"})).code, 0);
    here.file("weights.json", R"({"format": "internode-curves", "curves": [{"points": [[0], [1]]},)"
                              R"( {"points": [[0], [1]], "weights": [1, 2]}]})");
    refused(lines("weights.json"), "one polygon has 1 columns, another 2");
    EXPECT_EQ(run(lines("weights.json", {"--limit"})).code, 0) << "points of the curve have no weights";
}

TEST_F(Parts, CountTogetherForThePlanAndItsLimit) {
    EXPECT_THAT(run(lines("two.csv", {"--plan"})).out, HasSubstr("points 8\nbytes of points 128\n"));
    refused(lines("two.csv", {"--max-points", "7"}), "1 steps give more than 7 points");
    EXPECT_EQ(run(lines("two.csv", {"--max-points", "8"})).code, 0);
}

class Parameters : public Parts {
protected:
    const std::string ramp = R"({"degree":2,"closed":false,"points":[[0],[1],[4],[9]],"knots":[5,5,5,6,7,7,7]})";
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 4 0 0\nv 9 0 0\ncstype bspline\ndeg 2\ncurv 5 7 1 2 3 4\n"
                            "parm u 5 5 5 6 7 7 7\nend\n";
    /// The column t of a CSV.
    static std::string times(const std::string& csv) {
        std::string result;
        bool first = true;
        for (const char c : csv) {
            if (first && c != ',') result += c;
            if (c == ',') first = false;
            if (c == '\n') {
                if (!first) result += ' ';
                first = true;
            }
        }
        return result;
    }
};

TEST_F(Parameters, AreTheFilesInEveryFormat) {
    here.file("ramp.json", ramp);
    here.file("ramp.obj", obj);
    for (const std::string file : {"ramp.json", "ramp.obj"}) {
        EXPECT_EQ(times(run({file, "-n", "0", "--limit"}).out), "t 5 6 7 ") << file;
        EXPECT_EQ(times(run({file, "-n", "1", "--limit"}).out), "t 5 5.5 6 6.5 7 ") << file;
        EXPECT_EQ(times(run({file, "-n", "0", "--limit", "--derivatives"}).out), "t 5 6 7 ") << file;
    }
    here.file("ring.json", R"({"degree":1,"closed":true,"points":[[0],[1],[4]],"knots":[-1,0,2,3]})");
    EXPECT_EQ(times(run({"ring.json", "-n", "0", "--limit"}).out), "t -1 0 2 ");
}

TEST_F(Parameters, AreKeptInJsonAndBack) {
    here.file("ramp.json", ramp);
    ASSERT_EQ(run({"ramp.json", "-n", "1", "-o", "fine.json"}).code, 0);
    EXPECT_THAT(here.read("fine.json"), AllOf(HasSubstr(R"("origin": {"value": 5, "exact": ["5"]})"),
                                              HasSubstr(R"("knots": [5, 5, 5, 5.5, 6, 6.5, 7, 7, 7])"),
                                              HasSubstr(R"("word": ["0", "0", "A")")));
    EXPECT_EQ(times(run({"fine.json", "-n", "0", "--limit"}).out), "t 5 5.5 6 6.5 7 ");
}

TEST_F(Parameters, AreWrittenUpToAQuarterOfAMillion) {
    std::string rows = "x\n";
    for (int i = 0; i < 249'997; ++i) rows += "1\n";
    const auto written = [&](const std::string& points) {
        here.file("long.csv", points);
        const Outcome outcome =
            run({"long.csv", "-d", "2", "--word", "A", "--repeat", "--open", "-n", "0", "--format", "json"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out.find("\"knots\": [") != std::string::npos;
    };
    EXPECT_TRUE(written(rows)) << "250,000 knots";
    EXPECT_FALSE(written(rows + "1\n"));
}

TEST_F(Parameters, GoThroughReverseAndCompose) {
    here.file("ramp.json", ramp);
    ASSERT_EQ(run({"ramp.json", "-n", "1", "-o", "fine.json"}).code, 0);
    ASSERT_EQ(here.run({"reverse", "@bisection", "fine.json", "--clamped", "--word", "A A", "-n", "1", "-o", "p.json",
                        "--coarse", "coarse.json"})
                  .code,
              0);
    EXPECT_THAT(here.read("p.json"), HasSubstr(R"("origin": {"value": 5, "exact": ["5"]})"));
    EXPECT_EQ(times(run({"coarse.json", "-n", "0", "--limit"}).out), "t 5 6 7 ");
    ASSERT_EQ(here.run({"compose", "p.json", "-o", "composed.json"}).code, 0);
    EXPECT_EQ(times(run({"composed.json", "-n", "0", "--limit"}).out), "t 5 5.5 6 6.5 7 ");
}

TEST_F(Parameters, OfAGridStandInItsJson) {
    here.file("grid.json", R"({"degree":[1,1],"knots":[[5,5,6,7,7],[-1,-1,1,1]],)"
                           R"("points":[[[0],[1]],[[2],[3]],[[4],[5]]]})");
    const Outcome fine = here.run({"subdivide", "--u", "@bisection", "--v", "@bisection", "grid.json", "-n", "1"});
    ASSERT_EQ(fine.code, 0) << fine.err;
    EXPECT_THAT(fine.out, AllOf(HasSubstr("\"origin\": [\n    {\"value\": 5, \"exact\": [\"5\"]},\n    {\"value\": -1"),
                                HasSubstr("\"knots\": [\n    [5, 5, 5.5, 6, 6.5, 7, 7],\n    [-1, -1, 0, 1, 1]\n  ]")));
    here.file("fine.json", fine.out);
    EXPECT_EQ(here.run({"subdivide", "--u", "@bisection", "--v", "@bisection", "fine.json", "-n", "0"}).code, 0);
}

TEST_F(Parameters, OfAnObjAreTakenApart) {
    here.file("ramp.json", ramp);
    here.file("fine.obj", "v 0 0 0\nv 0.5 0 0\nv 2 0 0\nv 4 0 0\nv 6.5 0 0\nv 9 0 0\ncstype bspline\ndeg 2\n"
                          "curv 5 7 1 2 3 4 5 6\nparm u 5 5 5 5.5 6 6.5 7 7 7\nend\n");
    for (const std::vector<std::string>& word : std::vector<std::vector<std::string>>{{}, {"--word", "A A"}}) {
        std::vector<std::string> arguments{"reverse", "@bisection", "fine.obj", "-n", "1", "--coarse", "coarse.json"};
        arguments.insert(arguments.end(), word.begin(), word.end());
        const Outcome outcome = here.run(arguments);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(times(run({"coarse.json", "-n", "0", "--limit"}).out), "t 5 6 7 ");
    }
    here.file("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2 3 4\n");
    EXPECT_EQ(
        here.run({"reverse", "@bisection", "line.obj", "-d", "1", "--word", "A", "--repeat", "-n", "1", "--cut"}).code,
        0);
}

TEST_F(Parameters, RefuseLengthsOfZeroWithTheirPlace) {
    here.file("zero.json",
              "{\"degree\":1,\"closed\":true,\"points\":[[0],[1]],\"word\":\"L S\",\n\"lengths\":{\"L\":0}}");
    const Outcome outcome = here.run({"subdivide", "@fibonacci", "zero.json", "-n", "1"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("zero.json:2:12: error: the length of `L` must be positive"));
    EXPECT_EQ(here.run({"reverse", "@fibonacci", "zero.json", "-n", "0", "--word", "L S"}).code, 3);
}

} // namespace
} // namespace internode::tests
