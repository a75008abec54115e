// SPDX-License-Identifier: MIT
//
// subdivide and converge: how word, ends and degree are settled between file and command line, and what is refused.

#include "tests/cli/command.h"

#include "internode/grammar/bundled.h"
#include "tests/fixtures/stride.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace internode::tests {
namespace {

using testing::HasSubstr;

const std::string square = "x,y\n0,0\n1,0\n1,1\n0,1\n";

long rows(const std::string& csv) {
    return std::ranges::count(csv, '\n') - 1;
}

class Subdivide : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"subdivide", "@fibonacci"});
        return here.run(arguments);
    }
    void SetUp() override { here.file("square.csv", square); }
    Workspace here;
};

TEST_F(Subdivide, SettlesTheEnds) {
    EXPECT_EQ(rows(run({"square.csv", "-d", "2", "-n", "1", "--closed", "--word", "LSLS"}).out), 6);
    EXPECT_EQ(rows(run({"square.csv", "-d", "2", "-n", "1", "--word", "(LSLS)"}).out), 6);
    EXPECT_EQ(rows(run({"square.csv", "-d", "2", "-n", "1", "--word", "LSLSLS"}).out), 5);
    EXPECT_EQ(rows(run({"square.csv", "-d", "2", "-n", "1", "--open", "--word", "LSLSLS"}).out), 5);
    EXPECT_EQ(rows(run({"square.csv", "-d", "2", "-n", "1", "--clamped", "--word", "LS"}).out), 5);
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "1", "--clamped", "--word", "LS"}).out,
              run({"square.csv", "-d", "2", "-n", "1", "--word", "0 0 L S 0 0"}).out);
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "1", "--open", "--word", "(LSLS)"}).code, 3);
}

TEST_F(Subdivide, RepeatsLettersAndCuts) {
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "2", "--closed", "--word", "LSL", "--repeat"}).out,
              run({"square.csv", "-d", "2", "-n", "2", "--closed", "--word", "LSLL"}).out);
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "2", "--word", "LSL", "--repeat"}).out,
              run({"square.csv", "-d", "2", "-n", "2", "--word", "LSLLSL"}).out);
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "2", "--clamped", "--word", "S", "--repeat"}).out,
              run({"square.csv", "-d", "2", "-n", "2", "--clamped", "--word", "SS"}).out);
    EXPECT_EQ(run({"square.csv", "-d", "2", "-n", "2", "--closed", "--word", "LSLSLS", "--repeat"}).code, 3);
}

TEST_F(Subdivide, ClosedFromOnePoint) {
    here.file("point.csv", "3,4\n");
    const Outcome outcome = run({"point.csv", "-d", "3", "-n", "2", "--closed", "--word", "L"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "x,y\n3,4\n3,4\n3,4\n");
}

TEST_F(Subdivide, RefusesWithTheNumbers) {
    const auto refused = [this](const std::vector<std::string>& arguments, const std::string& word) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 3) << testing::PrintToString(arguments) << outcome.out;
        EXPECT_THAT(outcome.err, HasSubstr(word));
        EXPECT_EQ(outcome.out, "");
    };
    refused({"square.csv", "-d", "2", "-n", "1"}, "no word");
    refused({"square.csv", "-d", "2", "-n", "1", "--closed", "--word", "LSL"}, "4");
    refused({"square.csv", "-d", "2", "-n", "1", "--word", "LSLSL"}, "6 letters");
    refused({"square.csv", "-d", "4", "-n", "1", "--word", "L", "--repeat"}, "5");
    refused({"square.csv", "-d", "2", "-n", "1", "--closed", "--word", "LXLS"}, "X");
    refused({"square.csv", "-d", "1", "-n", "1", "--closed", "--word", "L 0 0 S"}, "2 zeros in a row");
    refused({"square.csv", "-d", "2", "-n", "1000000000", "--closed", "--word", "LSLS"}, "100000000");
    refused({"square.csv", "-d", "2", "-n", "9", "--closed", "--word", "LSLS", "--max-points", "99"}, "99");
    here.file("repeat.csv", square + "0,0\n");
    refused({"repeat.csv", "-d", "2", "-n", "1", "--closed", "--word", "L", "--repeat"}, "drop the last point");
    here.file("nan.csv", "0,0\n1,nan\n");
    refused({"nan.csv", "-d", "1", "-n", "1", "--closed", "--word", "LS"}, "nan.csv:2:3");
    here.file("ragged.csv", "0,0\n1,2,3\n");
    refused({"ragged.csv", "-d", "1", "-n", "1", "--closed", "--word", "LS"}, "ragged.csv:2");
    here.file("lengths.json", R"({"format":"internode-curve","version":1,"degree":1,"closed":true,"word":["L","S"],
        "points":[[0],[1]],"lengths":{"L":"1.618","S":1}})");
    refused({"lengths.json", "-n", "1"}, "lengths.json");
    here.file("long.csv", "1,2,3,4\n5,6,7,8\n");
    refused({"long.csv", "-d", "1", "-n", "1", "--closed", "--word", "LS", "--format", "obj"}, "3 coordinates");
}

TEST_F(Subdivide, JsonSaysDegreeWordAndEnds) {
    here.file("c.json", R"({"format":"internode-curve","version":1,"degree":2,"closed":true,
        "word":["L","S","L","S"],"points":[[0,0],[1,0],[1,1],[0,1]]})");
    EXPECT_EQ(run({"c.json", "-n", "2"}).out,
              run({"square.csv", "-d", "2", "-n", "2", "--closed", "--word", "LSLS"}).out);
    EXPECT_EQ(run({"c.json", "-n", "2", "-d", "3"}).code, 3);
    EXPECT_EQ(run({"c.json", "-n", "2", "--open"}).code, 3);
    const Outcome other = run({"c.json", "-n", "1", "--word", "LLLL"});
    EXPECT_EQ(rows(other.out), 8);
    EXPECT_EQ(run({"square.csv", "-n", "2"}).code, 2);
}

TEST_F(Subdivide, TheAxiomIsTheWholeWordAndMustAgree) {
    here.file("g.lsys", "intervals g\nL -> S L\nS -> L\naxiom (L S L S)\n");
    EXPECT_EQ(here.run({"subdivide", "g.lsys", "square.csv", "-d", "2", "-n", "1"}).out,
              run({"square.csv", "-d", "2", "-n", "1", "--closed", "--word", "LSLS"}).out);
    here.file("c.json", R"({"degree":2,"closed":true,"word":["L","L","L","S"],"points":[[0,0],[1,0],[1,1],[0,1]]})");
    const Outcome disagree = here.run({"subdivide", "g.lsys", "c.json", "-n", "1"});
    EXPECT_EQ(disagree.code, 3);
    EXPECT_THAT(disagree.err, HasSubstr("disagree"));
    EXPECT_EQ(here.run({"subdivide", "g.lsys", "c.json", "-n", "1", "--word", "LLLS"}).code, 0);
}

TEST_F(Subdivide, OutputIsInputAgain) {
    ASSERT_EQ(run({"data/curves/fibonacci-open.json", "-n", "2", "-o", "two.json"}).code, 0);
    EXPECT_EQ(run({"two.json", "-n", "1"}).out, run({"data/curves/fibonacci-open.json", "-n", "3"}).out);
    EXPECT_EQ(run({"two.json", "-n", "1", "--limit"}).out.substr(0, 40),
              run({"data/curves/fibonacci-open.json", "-n", "3", "--limit"}).out.substr(0, 40));
}

TEST_F(Subdivide, PlansWhatItMakesForEveryBundledGrammar) {
    for (const BundledGrammar& grammar : bundled_grammars(GrammarKind::Intervals)) {
        const std::string name = "@" + std::string(grammar.name);
        if (here.run({"validate", name}).code != 0) continue;
        const std::string letter = here.run({"validate", name, "--json"}).out;
        const auto at = letter.find("\"name\": \"", letter.find("\"symbols\": ["));
        const std::string symbol = letter.substr(at + 9, letter.find('"', at + 9) - at - 9);
        for (const std::string steps : {"0", "1", "6"}) {
            const std::vector<std::string> job{"subdivide", name,       "square.csv", "-d",   "2",       "-n",
                                               steps,       "--closed", "--word",     symbol, "--repeat"};
            auto plan = job;
            plan.emplace_back("--plan");
            const Outcome planned = here.run(plan);
            ASSERT_EQ(planned.code, 0) << planned.err;
            const Outcome done = here.run(job);
            ASSERT_EQ(done.code, 0) << done.err;
            EXPECT_THAT(planned.out, HasSubstr("points " + std::to_string(rows(done.out)) + "\n")) << name;
        }
    }
}

#ifndef INTERNODE_SANITIZED // a sanitizer's shadow memory is no promise of ours
std::vector<std::string> coast(std::initializer_list<std::string> more) {
    std::vector<std::string> line{
        "subdivide", "@fibonacci", "data/curves/iceland-coast.csv", "-d", "3", "--closed", "--word", "LS", "--repeat"};
    line.insert(line.end(), more);
    return line;
}

std::uint64_t planned_memory(const std::string& plan) {
    return std::stoull(plan.substr(plan.find("memory ") + 7));
}

TEST_F(Subdivide, TakesNoMoreMemoryThanPlanned) {
    const std::uint64_t small = here.peak_memory(coast({"-n", "0", "-o", "out.npy"}));
    const std::uint64_t large = here.peak_memory(coast({"-n", "14", "-o", "out.npy"}));
    const std::uint64_t planned = planned_memory(here.run(coast({"-n", "14", "--plan"})).out);
    ASSERT_GT(planned, std::uint64_t{64} << 20);
    EXPECT_LE(large - small, planned + planned * 15 / 100);
}

TEST_F(Subdivide, APictureOfManyStepsTakesNoMoreMemoryThanPlanned) {
    const std::uint64_t small = here.peak_memory(coast({"-n", "0", "-o", "out.npy"}));
    const std::uint64_t large = here.peak_memory(coast({"-n", "14", "-o", "out.svg"}));
    const std::uint64_t planned = planned_memory(here.run(coast({"-n", "14", "--plan", "--format", "svg"})).out);
    EXPECT_LE(large - std::min(small, large), planned + planned * 15 / 100);
    EXPECT_LT(planned, std::uint64_t{64} << 20) << "no more is drawn than can be seen";
}

TEST_F(Subdivide, APictureOfManyGivenPointsTakesNoMoreMemoryThanPlanned) {
    std::string points;
    for (int i = 0; i < 250'000; ++i) points += std::to_string(i % 997) + "," + std::to_string(i % 1009) + "\n";
    here.file("many.csv", points);
    const std::vector<std::string> job{"subdivide", "@fibonacci", "many.csv", "-d", "3",  "--closed", "--word",
                                       "LS",        "--repeat",   "--format", "",   "-n", "0"};
    const auto as = [&job](const std::string& format, std::initializer_list<std::string> more) {
        auto line = job;
        line[10] = format;
        line.insert(line.end(), more);
        return line;
    };
    const std::uint64_t small = here.peak_memory(as("npy", {"-o", "out"}));
    const std::uint64_t large = here.peak_memory(as("svg", {"-o", "out"}));
    const std::uint64_t planned = planned_memory(here.run(as("svg", {"--plan"})).out);
    ASSERT_GT(planned, std::uint64_t{64} << 20);
    EXPECT_LE(large - std::min(small, large), planned + planned * 15 / 100);
}
#endif

TEST_F(Subdivide, APictureSaysHowManyStepsItShows) {
    const std::vector<std::string> coast{
        "data/curves/iceland-coast.csv", "-d", "3", "--closed", "--word", "LS", "--repeat", "--format", "svg", "-n"};
    const auto picture = [&](const std::string& steps) {
        auto line = coast;
        line.push_back(steps);
        return run(line).out;
    };
    EXPECT_THAT(picture("2"), ::testing::Not(HasSubstr("Drawn after")));
    const std::string many = picture("12");
    EXPECT_THAT(many, HasSubstr("Drawn after 6 of 12 steps"));
    EXPECT_THAT(here.run({"limits"}).out, HasSubstr("points of a curve in a picture"));
    // The same curve: the last picture is that of six steps, but for its title, its metadata and the remark.
    const auto limit = [](const std::string& svg) {
        const std::size_t start = svg.find("<g id=\"limit\"");
        return svg.substr(start, svg.find("</g>", start) - start);
    };
    EXPECT_EQ(limit(many), limit(picture("6")));
}

TEST_F(Subdivide, LimitHasTheParameterAsAColumn) {
    const Outcome limit = run({"square.csv", "-d", "2", "-n", "1", "--clamped", "--word", "LS", "--limit"});
    EXPECT_EQ(limit.code, 0) << limit.err;
    EXPECT_EQ(limit.out.substr(0, 12), "t,x,y\n0,0,0\n");
    EXPECT_EQ(
        run({"square.csv", "-d", "2", "-n", "1", "--clamped", "--word", "LS", "--limit", "--format", "json"}).code, 2);
}

TEST_F(Subdivide, DerivativesAreMoreColumnsOfTheLimit) {
    // One quadratic piece over S = 1: c' = (2, 0), then (0, 2); c'' = (-2, 2).
    here.file("corner.csv", "x,y\n0,0\n1,0\n1,1\n");
    const std::vector<std::string> options{"-d", "2",       "-n",           "0", "--clamped", "--word",
                                           "S",  "--limit", "--derivatives"};
    const auto frames_of = [&](const std::string& file) {
        std::vector<std::string> line{file};
        line.insert(line.end(), options.begin(), options.end());
        return run(line);
    };
    const Outcome frames = frames_of("corner.csv");
    EXPECT_EQ(frames.code, 0) << frames.err;
    EXPECT_EQ(frames.out, "t,x,y,dx,dy,ddx,ddy,tx,ty,curvature\n"
                          "0,0,0,2,0,-2,2,1,0,0.5\n"
                          "1,1,1,0,2,-2,2,0,1,0.5\n");
    here.file("stop.csv", "0,0\n0,0\n1,1\n");
    const Outcome stop =
        run({"stop.csv", "-d", "2", "-n", "0", "--clamped", "--word", "S", "--limit", "--derivatives"});
    EXPECT_THAT(stop.out, HasSubstr("\n0,0,0,0,0,2,2,,,\n")) << "no tangent where the curve stops";
    here.file("far.csv", "0,0\n1e300,1e308\n1,1\n");
    EXPECT_EQ(frames_of("far.csv").code, 3);
    here.file("fast.csv", "-1e308,0\n1e308,0\n");
    const Outcome fast =
        run({"fast.csv", "-d", "1", "-n", "0", "--clamped", "--word", "S", "--limit", "--derivatives"});
    EXPECT_EQ(fast.code, 3) << "the first derivative alone is too large: the second one is 0";
    EXPECT_THAT(fast.err, HasSubstr("larger than every double"));
    here.file("bend.csv", "0,0\n8e307,0\n0,0\n");
    EXPECT_EQ(frames_of("bend.csv").code, 3) << "the second derivative alone is too large: the first one is 1.6e308";
}

TEST_F(Subdivide, DerivativesOfALineFarAwayDoNotBend) {
    here.file("line.csv", "1310003.1,6123456.7\n1310002.6,6123456.7\n1310001.9,6123456.7\n1310000.8,6123456.7\n"
                          "1310000.2,6123456.7\n1309999.9,6123456.7\n");
    const Outcome frames = here.run({"subdivide", "@bisection", "line.csv", "-d", "3", "-n", "8", "--clamped", "--word",
                                     "AAA", "--limit", "--derivatives"});
    ASSERT_EQ(frames.code, 0) << frames.err;
    std::size_t straight = 0;
    for (std::size_t at = frames.out.find(",-1,0,"); at != std::string::npos; at = frames.out.find(",-1,0,", at + 1))
        straight += frames.out.substr(at + 6, 2) == "0\n" ? 1 : 0;
    EXPECT_EQ(straight, 3U * 256 + 1) << "unit tangent -1 0 and curvature 0, not -0, in every row";
}

TEST_F(Subdivide, DerivativesInNpyAreTheSameColumns) {
    ASSERT_EQ(run({"square.csv", "-d", "3", "-n", "1", "--clamped", "--word", "L", "--limit", "--derivatives", "-o",
                   "limit.npy"})
                  .code,
              0);
    EXPECT_THAT(here.read("limit.npy"), HasSubstr("'shape': (3, 10)"));
}

TEST_F(Subdivide, HostileNamesAreTextInPictures) {
    const std::string name = "</script><img src=x onerror=1>]]>";
    here.file("evil.lsys", "intervals \"" + name + "\"\nL -> S L\nS -> L\n");
    const Outcome picture =
        here.run({"subdivide", "evil.lsys", "square.csv", "-d", "2", "-n", "1", "--word", "(LSLS)", "--format", "svg"});
    ASSERT_EQ(picture.code, 0) << picture.err;
    EXPECT_EQ(picture.out.find("<img"), std::string::npos);
    EXPECT_EQ(picture.out.find("]]>"), std::string::npos);
}

TEST_F(Subdivide, ConvergeReportsAndWritesThePage) {
    const Outcome text = here.run({"converge", "@fibonacci", "square.csv", "-d", "3", "-n", "6", "--word", "(LSLS)",
                                   "--tolerance", "1e-3", "--html", "page.html"});
    ASSERT_EQ(text.code, 0) << text.err;
    EXPECT_THAT(text.out, HasSubstr("0.38"));
    EXPECT_THAT(here.read("page.html"), HasSubstr("default-src 'none'"));
    const Outcome json =
        here.run({"converge", "@fibonacci", "square.csv", "-d", "3", "-n", "6", "--word", "(LSLS)", "--json"});
    EXPECT_THAT(json.out, HasSubstr("\"internode-convergence\""));
    EXPECT_EQ(
        here.run({"converge", "@fibonacci", "square.csv", "-d", "3", "-n", "1000000000", "--word", "(LSLS)"}).code, 3);
}

TEST_F(Subdivide, GivesTheSameBytesForAnyThreadsInstructionSetAndStores) {
    const std::string steps = tests::in_full() ? "12" : "9";
    const std::string line =
        "\"$INTERNODE\" subdivide @fibonacci data/curves/iceland-coast.csv -d 3 --closed --word LS "
        "--repeat --format npy -n " +
        steps + " ";
    const Outcome expected = here.shell(line + "| sha256sum");
    EXPECT_EQ(expected.code, 0) << expected.err;
    for (const std::string with : {"--threads 1", "--threads=3", "--threads 0"})
        EXPECT_EQ(here.shell(line + with + " | sha256sum").out, expected.out) << with;
    for (const std::string isa : {"plain", "avx2", ""})
        EXPECT_EQ(here.shell("INTERNODE_ISA=" + isa + " " + line + "| sha256sum").out, expected.out) << isa;
    for (const std::string stores : {"cached", "streamed", ""})
        EXPECT_EQ(here.shell("INTERNODE_STORES=" + stores + " " + line + "| sha256sum").out, expected.out) << stores;
    for (const std::string variable : {"INTERNODE_ISA", "INTERNODE_STORES"}) {
        const Outcome refused = here.shell(variable + "=sse9 " + line + "> /dev/null");
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.err, ::testing::HasSubstr(variable));
    }
}

} // namespace
} // namespace internode::tests
