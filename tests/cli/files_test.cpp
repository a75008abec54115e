// SPDX-License-Identifier: MIT
//
// Promises about files and streams, held from outside: exit codes, whole outputs, quiet pipes.

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace internode::tests {
namespace {

using testing::HasSubstr;

long count_lines(const std::string& text) {
    return std::ranges::count(text, '\n');
}

TEST(Files, ThatAreMissingOrFoldersAreExitFour) {
    const Workspace here;
    for (const std::string place : {"nowhere.lsys", ".", "/"}) {
        const Outcome outcome = here.run({"validate", place});
        EXPECT_EQ(outcome.code, 4) << place << outcome.err;
        EXPECT_EQ(count_lines(outcome.err), 1);
    }
    EXPECT_EQ(here.run({"subdivide", "@fibonacci", "nowhere.csv", "-d", "2", "-n", "1"}).code, 4);
}

TEST(Files, EndlessInputsEnd) {
    const Workspace here;
    EXPECT_EQ(here.run({"validate", "/dev/zero"}).code, 3);
    const Outcome sparse =
        here.shell("truncate -s 5G big.csv && \"$INTERNODE\" subdivide @fibonacci big.csv -d 2 -n 1");
    EXPECT_EQ(sparse.code, 3) << sparse.err;
    const Outcome silent =
        here.shell("mkfifo pipe; sleep 20 > pipe & \"$INTERNODE\" validate pipe & child=$!; sleep 0.3; "
                   "kill -INT $child; wait $child; code=$?; kill %1; exit $code");
    EXPECT_EQ(silent.code, 130) << silent.err;
}

TEST(Files, AFullDiskIsExitFourAndOneLine) {
    const Workspace here;
    for (const std::string command : {"validate @fibonacci", "masks @fibonacci -d 3", "grammars", "limits",
                                      "subdivide @fibonacci data/curves/fibonacci-open.json -n 3"}) {
        const Outcome outcome = here.shell("\"$INTERNODE\" " + command + " > /dev/full");
        EXPECT_EQ(outcome.code, 4) << command;
        EXPECT_EQ(count_lines(outcome.err), 1) << outcome.err;
    }
    EXPECT_EQ(here.shell("\"$INTERNODE\" grammars >&-").code, 4);
}

TEST(Files, AnUnwritableFolderIsNoticedBeforeTheWork) {
    const Workspace here;
    const Outcome outcome = here.run({"masks", "@fibonacci", "-d", "2", "-o", "nowhere/masks.json"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("nowhere/masks.json"));
}

TEST(Files, ABrokenPipeIsPolite) {
    const Outcome outcome = Workspace().shell(
        "\"$INTERNODE\" subdivide @fibonacci data/curves/iceland-coast.csv -d 3 -n 6 --closed --word LS --repeat "
        "| head -1");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(count_lines(outcome.out), 1);
}

TEST(Files, AnInterruptLeavesTheOldFileAndNoOther) {
    const Workspace here;
    here.file("old.csv", "precious\n");
    const Outcome outcome = here.shell(
        "\"$INTERNODE\" subdivide @fibonacci data/curves/iceland-coast.csv -d 12 -n 14 --closed --word LS --repeat "
        "-o old.csv & child=$!; sleep 0.5; kill -INT $child; wait $child");
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(here.read("old.csv"), "precious\n");
    const auto entries = std::filesystem::directory_iterator(here.path());
    const auto stray = std::count_if(begin(entries), end(entries), [](const auto& entry) {
        return entry.path().string().find(".tmp") != std::string::npos;
    });
    EXPECT_EQ(stray, 0);
}

TEST(Files, TheSameCommandGivesTheSameBytesWhereverItRuns) {
    const Workspace one;
    const Workspace two;
    std::filesystem::create_directory(two.path() / "folder");
    for (const std::string extension : {"csv", "json", "npy", "obj", "svg"}) {
        const std::vector<std::string> command{"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "3"};
        auto first = command;
        first.insert(first.end(), {"-o", "a." + extension});
        auto second = command;
        second[2] = "./data/curves/../curves/fibonacci-open.json";
        second.insert(second.end(), {"-o", "folder/b." + extension});
        ASSERT_EQ(one.run(first).code, 0);
        ASSERT_EQ(two.run(second).code, 0);
        EXPECT_EQ(one.read("a." + extension), two.read("folder/b." + extension)) << extension;
    }
}

} // namespace
} // namespace internode::tests
