// SPDX-License-Identifier: MIT

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;

std::vector<std::string> examples_in(const std::string& help) {
    std::vector<std::string> lines;
    std::istringstream stream(help);
    for (std::string line; std::getline(stream, line);)
        if (line.rfind("  internode ", 0) == 0) lines.push_back(line.substr(12));
    return lines;
}

TEST(Help, OpensWithTwoExamplesThatRun) {
    const Workspace here;
    for (const std::string& command : commands) {
        const Outcome help = here.run({command, "--help"});
        ASSERT_EQ(help.code, 0) << help.err;
        const auto lines = examples_in(help.out);
        ASSERT_EQ(lines.size(), 2U) << help.out;
        for (const std::string& line : lines) {
            const Outcome outcome = here.run(split(line));
            EXPECT_EQ(outcome.code, 0) << line << '\n' << outcome.err;
            EXPECT_EQ(outcome.err, "") << line;
        }
    }
}

TEST(Help, OfSubdivideGroupsItsOptionsByKind) {
    const std::string help = Workspace().run({"subdivide", "--help"}).out;
    EXPECT_THAT(help, HasSubstr("bundled one, or - (left out with -e)"));
    for (const char* heading : {"Interval grammars and grids:", "Interval grammars:", "Grids:", "Point grammars:"})
        EXPECT_THAT(help, HasSubstr("\n" + std::string(heading) + "\n"));
}

TEST(Help, OfTheProgramNamesEveryCommand) {
    const Workspace here;
    for (const Outcome& help : {here.run({"--help"}), here.run({})}) {
        EXPECT_EQ(help.code, 0);
        for (const std::string& command : commands) EXPECT_THAT(help.out, HasSubstr("\n  " + command));
    }
}

TEST(Help, VersionNamesCompilerInstructionSetAndLibraries) {
    const Outcome version = Workspace().run({"--version"});
    EXPECT_EQ(version.code, 0);
    for (const char* word : {"internode ", "compiler ", "instruction set ", "e-antic 1.", "FLINT ", "fmt ", "GMP "})
        EXPECT_THAT(version.out, HasSubstr(word));
}

TEST(Usage, MisspeltCommandsAndOptionsAreMet) {
    const Workspace here;
    const Outcome command = here.run({"valdate", "@fibonacci"});
    EXPECT_EQ(command.code, 2);
    EXPECT_THAT(command.err, HasSubstr("did you mean `validate`?"));
    const Outcome option = here.run({"masks", "@fibonacci", "--degre", "2"});
    EXPECT_EQ(option.code, 2);
    const Outcome near = here.run({"masks", "@fibonacci", "-d", "2", "--jsn"});
    EXPECT_EQ(near.code, 2);
    EXPECT_THAT(near.err, HasSubstr("did you mean `--json`?"));
    const Outcome bundled = here.run({"validate", "@fibonaci"});
    EXPECT_EQ(bundled.code, 2);
    EXPECT_THAT(bundled.err, HasSubstr("did you mean `@fibonacci`?"));
}

TEST(Usage, WrongArgumentsAreExitTwo) {
    const Workspace here;
    const std::vector<std::vector<std::string>> lines{
        {"validate"},
        {"validate", "@fibonacci", "-e", "A->AA"},
        {"masks", "@fibonacci"},
        {"masks", "@fibonacci", "-d", "0"},
        {"masks", "@fibonacci", "-d", "13"},
        {"masks", "@fibonacci", "-d", "two"},
        {"masks", "@fibonacci", "-d", "2", "--format", "png"},
        {"masks", "@fibonacci", "-d", "2", "-o", "masks.png"},
        {"subdivide", "@fibonacci", "-n", "1"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "-1"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--open", "--closed"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--format", "svg", "--axes", "1,9"},
        {"subdivide", "-", "-", "-n", "1"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "2.5"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "99999999999999999999"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--plan", "-o", "plan.csv"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--word", ""},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--derivatives"},
        {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--limit", "--derivatives", "-o",
         "limit.obj"},
        {"masks", "@fibonacci", "-d", "2", "--svg", "-o", "masks.json"},
        {"masks", "@fibonacci", "-d", "2", "--automaton", "--dot"},
        {"masks", "@fibonacci", "-d", "2", "--steps", "2"},
        {"masks", "@fibonacci", "-d", "2", "--automaton", "--steps", "0"},
        {"masks", "@fibonacci", "-d", "2", "--automaton", "-o", "automaton.svg"},
        {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--html", "-"},
        {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--tolerance", "0"},
        {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1", "--tolerance", "nan"},
        {"validate", "@fibonacci", "--color", "blue"},
    };
    for (const auto& line : lines) {
        const Outcome outcome = here.run(line);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(line) << outcome.out << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("error: "));
        EXPECT_EQ(outcome.out, "");
    }
}

} // namespace
} // namespace internode::tests
