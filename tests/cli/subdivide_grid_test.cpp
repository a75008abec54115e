// SPDX-License-Identifier: MIT
//
// subdivide --u --v: how words, ends and degrees of a grid are settled between file and command line, and what is
// refused.

#include "tests/cli/command.h"
#include "tests/fixtures/mesh_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;

class SubdivideGrid : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"subdivide", "--u", "@fibonacci", "--v", "@silver-mean"});
        return here.run(arguments);
    }
    /// Two rows of three points, closed both ways.
    void SetUp() override {
        here.file("g.json", R"({"degree":[2,1],"closed":[true,true],"word":["LS","LSS"],
            "points":[[[0,0,0],[0,1,0],[0,2,0]],[[1,0,0],[1,1,0],[1,2,1]]]})");
    }
    Workspace here;
};

TEST_F(SubdivideGrid, WritesEveryFormat) {
    for (const std::string file : {"wave.json", "wave.obj", "wave.ply", "wave.stl"}) {
        const Outcome outcome = run({"data/grids/wave.json", "-n", "2", "-o", file});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
    const tests::MeshFile obj = tests::read_obj(here.read("wave.obj"));
    const tests::MeshFile ply = tests::read_ply(here.read("wave.ply"));
    const tests::MeshFile stl = tests::read_stl(here.read("wave.stl"));
    EXPECT_EQ(obj.points, ply.points);
    EXPECT_EQ(obj.faces, ply.faces);
    EXPECT_EQ(stl.faces.size(), 2 * ply.faces.size());
    EXPECT_THAT(ply.header, HasSubstr("comment internode subdivide --u @fibonacci --v @silver-mean wave.json -n 2\n"));
    EXPECT_THAT(here.read("wave.json"), HasSubstr("\"format\": \"internode-grid\""));
}

TEST_F(SubdivideGrid, WritesTheSurfaceWithNormals) {
    const Outcome outcome = here.run({"subdivide", "--u", "@fibonacci", "--v", "@fibonacci", "data/grids/ring.json",
                                      "-n", "2", "--limit", "--normals", "-o", "ring.ply"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const tests::MeshFile mesh = tests::read_ply(here.read("ring.ply"));
    EXPECT_EQ(mesh.normals.size(), mesh.points.size());
    EXPECT_EQ(mesh.faces.size(), mesh.points.size() / 3); // closed both ways
}

TEST_F(SubdivideGrid, PlansWhatItMakes) {
    for (const std::string steps : {"0", "1", "4"}) {
        const Outcome plan = run({"data/grids/wave.json", "-n", steps, "--plan"});
        ASSERT_EQ(plan.code, 0) << plan.err;
        ASSERT_EQ(run({"data/grids/wave.json", "-n", steps, "-o", "wave.ply"}).code, 0);
        const std::size_t points = tests::read_ply(here.read("wave.ply")).points.size() / 3;
        EXPECT_THAT(plan.out, HasSubstr("points " + std::to_string(points) + "\n"));
    }
}

#ifndef INTERNODE_SANITIZED // a sanitizer's shadow memory is no promise of ours
TEST_F(SubdivideGrid, TakesNoMoreMemoryThanPlanned) {
    const std::vector<std::string> job{"subdivide", "--u", "@fibonacci", "--v", "@silver-mean", "data/grids/wave.json"};
    const auto with = [&job](std::initializer_list<std::string> more) {
        auto line = job;
        line.insert(line.end(), more);
        return line;
    };
    const std::uint64_t at_start = here.peak_memory(with({"-n", "0", "-o", "/dev/null", "--format", "ply"}));
    for (const std::string limit : {"", "--limit"}) {
        std::vector<std::string> plan = with({"-n", "9", "--plan"});
        std::vector<std::string> done = with({"-n", "9", "-o", "/dev/null", "--format", "ply"});
        if (!limit.empty()) {
            plan.push_back(limit);
            done.push_back(limit);
        }
        const Outcome planned = here.run(plan);
        ASSERT_EQ(planned.code, 0) << planned.err;
        std::istringstream words(planned.out);
        std::uint64_t bytes = 0;
        for (std::string line; std::getline(words, line);)
            if (line.starts_with("bytes of memory ")) bytes = std::stoull(line.substr(16));
        ASSERT_GT(bytes, 64'000'000u);
        EXPECT_LE(here.peak_memory(done) - at_start, bytes + bytes / 100 * 15);
    }
}
#endif

TEST_F(SubdivideGrid, OutputIsInputAgain) {
    ASSERT_EQ(run({"data/grids/wave.json", "-n", "2", "-o", "two.json"}).code, 0);
    ASSERT_EQ(run({"two.json", "-n", "1", "-o", "three.obj"}).code, 0);
    ASSERT_EQ(run({"data/grids/wave.json", "-n", "3", "-o", "at-once.obj"}).code, 0);
    const tests::MeshFile twice = tests::read_obj(here.read("three.obj"));
    const tests::MeshFile once = tests::read_obj(here.read("at-once.obj"));
    EXPECT_EQ(twice.faces, once.faces);
    ASSERT_EQ(twice.points.size(), once.points.size());
    for (std::size_t i = 0; i < once.points.size(); ++i) EXPECT_NEAR(twice.points[i], once.points[i], 1e-13);
}

TEST_F(SubdivideGrid, SettlesWordsAndDegrees) {
    here.file("bare.json", R"({"closed":[true,true],
        "points":[[[0,0,0],[0,1,0],[0,2,0]],[[1,0,0],[1,1,0],[1,2,1]]]})");
    const std::string expected = run({"g.json", "-n", "1", "--format", "obj"}).out;
    const auto same = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out.substr(outcome.out.find("\nv ")), expected.substr(expected.find("\nv ")));
    };
    same({"bare.json", "-n", "1", "--format", "obj", "-d", "2,1", "--word-u", "LS", "--word-v", "LSS"});
    same({"bare.json", "-n", "1", "--format", "obj", "-d", "2,1", "--word-u", "(LS)", "--word-v", "(LSS)"});
    same({"g.json", "-n", "1", "--format", "obj", "-d", "2,1"});
    same({"g.json", "-n", "1", "--format", "obj", "--word-u", "LS"});
    EXPECT_NE(run({"g.json", "-n", "1", "--word-u", "L", "--repeat"}).out, expected);
    EXPECT_EQ(run({"bare.json", "-n", "1", "-d", "2", "--word-u", "LS", "--word-v", "L", "--repeat"}).code, 0);
    EXPECT_EQ(run({"bare.json", "-n", "1"}).code, 2);
}

TEST_F(SubdivideGrid, RefusesWithTheNumbers) {
    const auto refused = [this](const std::vector<std::string>& arguments, const std::string& word) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 3) << testing::PrintToString(arguments) << outcome.out;
        EXPECT_THAT(outcome.err, HasSubstr(word));
        EXPECT_EQ(outcome.out, "");
    };
    refused({"g.json", "-n", "1", "-d", "3,1"}, "degree 3 along u");
    refused({"g.json", "-n", "1", "--word-u", "LSL"}, "2 points of degree 2 need a word of 2 letters");
    refused({"g.json", "-n", "1", "--word-v", "LSLS", "--repeat"}, "but --word-v has 4");
    refused({"g.json", "-n", "1", "--word-v", "LXS"}, "X");
    refused({"g.json", "-n", "1", "--word-v", "0 L 0"}, "2 zeros in a row");
    refused({"g.json", "-n", "1000000000"}, "100000000");
    refused({"g.json", "-n", "4", "--max-points", "99"}, "99");
    refused({"data/curves/square.csv", "-n", "1"}, "square.csv:1");
    refused({"data/curves/clamped.json", "-n", "1"}, "internode-grid");
    here.file("open.json", R"-({"degree":[1,1],"closed":[false,false],"word":["(LS)","LSS"],"points":[[[0]]]})-");
    refused({"open.json", "-n", "1"}, "is circular");
    here.file("unknown.json", R"({"degree":[1,1],"word":[["L","Q"],"LSS"],"points":[[[0]]]})");
    refused({"unknown.json", "-n", "1"}, "unknown.json:1:30");
    here.file("degree.json", R"({"degree":[13,1],"word":["L","L"],"points":[[[0]]]})");
    refused({"degree.json", "-n", "1"}, "13 along u");
    here.file("no-word.json", R"({"degree":[1,1],"points":[[[0]]]})");
    refused({"no-word.json", "-n", "1"}, "no word for the 1 points");
    here.file("weight.json",
              R"({"degree":[1,1],"closed":[true,true],"rational":true,"word":["L","L"],"points":[[[1,0]]]})");
    refused({"weight.json", "-n", "1"}, "every weight must be");
    here.file("four.json", R"({"degree":[1,1],"closed":[true,true],"word":["L","L"],"points":[[[1,2,3,4]]]})");
    refused({"four.json", "-n", "1", "--format", "obj"}, "at most 3 coordinates");
    here.file("two.json", R"({"degree":[1,1],"closed":[true,true],"word":["L","L"],"points":[[[1,2]]]})");
    refused({"two.json", "-n", "1", "--limit", "--normals"}, "3 coordinates");
    here.file("large.json", R"({"degree":[1,1],"closed":[true,true],"word":["L","L"],"points":[[[1e39]]]})");
    refused({"large.json", "-n", "1", "--format", "stl"}, "single precision");
    here.file("huge.json", R"({"degree":[1,1],"closed":[true,true],"rational":true,"word":["L","L"],
        "points":[[[1e300,1e-50]]]})");
    refused({"huge.json", "-n", "1", "--format", "ply"}, "range of doubles");
}

TEST_F(SubdivideGrid, OptionsThatDoNotFitAreExitTwo) {
    const std::vector<std::vector<std::string>> lines{
        {"subdivide", "--u", "@fibonacci", "g.json", "-n", "1"},
        {"subdivide", "--v", "@fibonacci", "g.json", "-n", "1"},
        {"subdivide", "--u", "@fibonacci", "--v", "@fibonacci", "-n", "1"},
        {"subdivide", "--u", "@fibonacci", "--v", "@fibonacci", "@fibonacci", "g.json", "-n", "1"},
        {"subdivide", "--u", "-", "--v", "-", "g.json", "-n", "1"},
        {"subdivide", "--u", "@fibonacci", "--v", "-", "-", "-n", "1"},
        {"subdivide", "--u", "@fibonacci", "--v", "@fibonacci", "g.json"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--normals"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--word-u", "L"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "-d", "3,2"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "-d", "3,"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--format", "ply"},
        {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "-d", "3,3"},
    };
    for (const auto& line : lines) EXPECT_EQ(here.run(line).code, 2) << testing::PrintToString(line);
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--closed"},
                                                                                      {"--word", "L"},
                                                                                      {"--axes", "1,2"},
                                                                                      {"--rational"},
                                                                                      {"-e", "A->AA"},
                                                                                      {"--normals"},
                                                                                      {"--limit", "--format", "json"},
                                                                                      {"--format", "csv"},
                                                                                      {"-o", "grid.svg"},
                                                                                      {"--plan", "-o", "grid.ply"},
                                                                                      {"-d", "2,1,1"},
                                                                                      {"-d", "0"},
                                                                                      {"--word-v", ""}}) {
        std::vector<std::string> line{"g.json", "-n", "1"};
        line.insert(line.end(), more.begin(), more.end());
        const Outcome outcome = run(line);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(line) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

} // namespace
} // namespace internode::tests
