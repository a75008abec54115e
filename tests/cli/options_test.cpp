// SPDX-License-Identifier: MIT
//
// No option is accepted that does nothing. The options are those that --help of each command lists, the lines below
// stand for every kind of grammar and every form of output. Each option is put on each line, and the command must then
// refuse it (exit 2) or do something else than before. The few that may change nothing are listed with their reason.

#include "tests/cli/command.h"
#include "tests/fixtures/stride.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

/// A value for each option, of a kind that matters where the option does.
const std::map<std::string, Words> samples{
    {"--output", {"out"}},
    {"--format", {"json"}},
    {"--json", {}},
    {"--color", {"always"}},
    {"--expression", {"A->A A"}},
    {"--set", {"w=1/8"}},
    {"--degree", {"2"}},
    {"--rational", {}},
    {"--element", {"1"}},
    {"--max-points", {"3"}},
    {"--axes", {"2,1"}},
    {"--threads", {"1"}},
    {"--plan", {}},
    {"--u", {"@fibonacci"}},
    {"--v", {"@fibonacci"}},
    {"--word-u", {"LSL"}},
    {"--word-v", {"LSL"}},
    {"--normals", {}},
    {"--limit", {}},
    {"--derivatives", {}},
    {"--query", {"C=1/4"}},
    {"--phase", {"1"}},
    {"--seed", {"5"}},
    {"--max-modules", {"3"}},
    {"--trace", {}},
    {"--tree", {}},
    {"--interpreter", {}},
    {"--quiet", {}},
    {"--verbose", {}},
    {"--closed", {}},
    {"--open", {}},
    {"--clamped", {}},
    {"--repeat", {}},
    {"--word", {"LSLLS"}},
    {"--steps", {"3"}},
    {"--levels", {"1"}},
    {"--tolerance", {"0.1"}},
    {"--html", {"page.html"}},
    {"--local", {}},
    {"--window", {"9"}},
    {"--threshold", {"9"}},
    {"--keep", {"2"}},
    {"--unclamped", {}},
    {"--resample", {}},
    {"--cut", {}},
    {"--coarse", {"c.csv"}},
    {"--picture", {"p.svg"}},
    {"--rules", {}},
    {"--level", {"0"}},
    {"--shift", {"1"}},
    {"--long", {}},
    {"--name", {"other"}},
    {"--max-letters", {"3"}},
    {"--all", {}},
    {"--points", {"5"}},
    {"--automaton", {}},
    {"--matrix", {}},
    {"--dot", {}},
    {"--svg", {}},
    {"--repair", {}},
};

/// What may change nothing: its effect hangs on the data, or is no byte of a result.
const std::map<std::string, std::string> may_be_idle{
    {"--color", "paints errors"},
    {"--element", "for files of several polygons"},
    {"--format", "may name the format that it is anyway"},
    {"--json", "may name the format that it is anyway"},
    {"--svg", "may name the format that it is anyway"},
    {"--automaton", "c and glsl are the tables of the automaton anyway"},
    {"--open", "may say the ends that the word has anyway"},
    {"--threads", "changes the time alone"},
    {"--quiet", "silences what only some data make the command say"},
    {"--verbose", "of a point grammar, says why it is interpreted: these are compiled"},
    {"--interpreter", "the reference for what is compiled: the same points"},
    {"--resample", "for polygons that do not fit"},
    {"--cut", "for polygons that do not fit"},
    {"--repeat", "for words that are too short"},
};

Words joined(Words first, const Words& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Words with_format(const Words& line, const std::string& format) {
    return joined(line, {"--format", format});
}

using Lines = std::vector<Words>;

Lines operator+(Lines first, const Lines& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The line once in each form.
Lines in_forms(const Words& line, const Words& forms) {
    Lines all;
    for (const std::string& form : forms) all.push_back(with_format(line, form));
    return all;
}

const std::string leaf_file = "data/curves/leaf.csv";
const std::string pebble = "data/curves/pebble.csv";
const std::string open_curve = "data/curves/fibonacci-open.json";
const Words own{"--expression", "L -> S L, S -> L"};

Lines validate_and_masks_lines() {
    const Words masks{"masks", "@fibonacci", "-d", "2"};
    return Lines{{"validate", "@fibonacci"},
                 {"validate", "@s0/13"},
                 {"validate", "@four-point"},
                 joined({"validate"}, own),
                 masks,
                 joined({"masks", "-d", "2"}, own),
                 joined(masks, {"--automaton"}),
                 joined(masks, {"--matrix", "--word", "LSLLSL"}),
                 {"masks", "@s0/13"},
                 {"masks", "@s0/13", "--automaton"},
                 {"masks", "@four-point"}} +
           in_forms(masks, {"json", "dot", "svg", "c", "glsl"}) + in_forms({"masks", "@s0/13"}, {"json", "mtx", "csv"});
}

Lines subdivide_lines() {
    const Words curve{"subdivide", "@fibonacci", leaf_file,  "-d", "2", "--closed",
                      "--word",    "LS",         "--repeat", "-n", "2"};
    const Words points{"subdivide", "@s0/13", pebble, "-n", "2"};
    const Words grid{"subdivide", "--u", "@fibonacci", "--v", "@silver-mean", "data/grids/wave.json", "-n", "1"};
    return Lines{curve,
                 joined(curve, {"--limit"}),
                 joined(curve, {"--limit", "--derivatives"}),
                 {"subdivide", "@fibonacci", open_curve, "-n", "1"},
                 points,
                 joined(points, {"--trace"}),
                 joined(points, {"--tree"}),
                 joined(points, {"--interpreter"}),
                 {"subdivide", "@koch", "-n", "1"},
                 {"subdivide", "@four-point", pebble, "-n", "1"},
                 {"subdivide", "@asked-cutting", pebble, "-n", "1"},
                 {"subdivide", "@midpoint-displacement", pebble, "-n", "1"},
                 {"subdivide", "@s0/34-36", pebble, "-n", "1"},
                 grid,
                 joined(grid, {"--limit"}),
                 joined(grid, {"--limit", "--normals"}),
                 with_format(joined(grid, {"--limit"}), "stl")} +
           in_forms(curve, {"json", "npy", "obj", "svg"}) + in_forms(points, {"json", "npy", "obj", "svg", "text"}) +
           in_forms(grid, {"obj", "ply", "stl"});
}

Lines reverse_lines() {
    const Words closed{"reverse", "@fibonacci", leaf_file,  "-d", "3", "--closed",
                       "--word",  "LS",         "--repeat", "-n", "2"};
    const Words points{"reverse", "@s0/13", leaf_file, "-n", "1"};
    const Words open{
        "reverse", "@fibonacci", "data/curves/signal.csv", "-d", "3", "--word", "LS", "--repeat", "--resample",
        "-n",      "1"};
    return Lines{closed,
                 joined(closed, {"--local"}),
                 open,
                 joined({"reverse", leaf_file, "-d", "2", "-n", "1", "--closed", "--word", "LS", "--repeat"}, own),
                 points,
                 {"reverse", "@s0/13", "--rules"},
                 {"reverse", "@four-point", leaf_file, "-n", "1"},
                 {"compose", "data/pyramids/leaf.json"}} +
           in_forms(points, {"json", "csv", "svg"});
}

Lines other_lines() {
    return {{"converge", "@fibonacci", open_curve, "-n", "2"},
            joined({"converge", open_curve, "-n", "1"}, own),
            {"infer", "data/matrices/chaikin.csv"},
            {"infer", "data/matrices/chaikin-open.csv", "--open"},
            {"infer", "data/matrices/chaikin.csv", "--format", "lsys"},
            {"word", "@fibonacci", "--word", "L", "-n", "3"},
            joined({"word", "--word", "L", "-n", "4"}, own),
            {"format", "@fibonacci", "--format", "text"},
            joined({"format"}, own),
            {"format", "@koch"},
            {"mesh", "data/meshes/tetrahedron.obj"},
            {"mesh", "data/meshes/tetrahedron.obj", "--repair"},
            {"formats"},
            {"grammars"},
            {"limits"}};
}

/// Lines of all kinds and forms, by command.
Lines lines() {
    return validate_and_masks_lines() + subdivide_lines() + reverse_lines() + other_lines();
}

/// The long names of the options that --help lists.
std::vector<std::string> options_of(const std::string& command) {
    const std::string help = Workspace().run({command, "--help"}).out;
    const std::regex option(R"(\n  (?:-\w,)?(--[\w-]+))");
    std::vector<std::string> names;
    for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
        if ((*at)[1] != "--help") names.push_back((*at)[1]);
    return names;
}

/// All that a line does, but for its own text in the metadata.
struct Effect {
    int code = 0;
    std::map<std::string, std::string> texts; ///< stdout, stderr and files by name
    friend bool operator==(const Effect&, const Effect&) = default;
};

Effect effect(const Words& line) {
    const Workspace here;
    const Outcome outcome = here.run(line);
    Effect result{outcome.code, {{"stdout", outcome.out}, {"stderr", outcome.err}}};
    for (const auto& entry : std::filesystem::directory_iterator(here.path()))
        if (entry.is_regular_file() && entry.path().filename().string().front() != '.')
            result.texts[entry.path().filename().string()] = here.read(entry.path().filename().string());
    const std::regex own_text("internode " + line.front() + "[^\n]*");
    for (auto& [name, text] : result.texts) text = std::regex_replace(text, own_text, "internode");
    return result;
}

bool stands_on(const Words& line, const std::string& option) {
    const std::map<std::string, std::string> brief{
        {"--degree", "-d"}, {"--steps", "-n"}, {"--levels", "-n"}, {"--output", "-o"}};
    const auto found = brief.find(option);
    return std::ranges::find(line, option) != line.end() ||
           (found != brief.end() && std::ranges::find(line, found->second) != line.end());
}

TEST(Options, EachHasASample) {
    std::set<std::string> seen;
    for (const std::string& command : commands) {
        const std::vector<std::string> names = options_of(command);
        EXPECT_GE(names.size(), 1U) << command;
        for (const std::string& name : names) {
            EXPECT_TRUE(samples.contains(name)) << command << ' ' << name;
            seen.insert(name);
        }
    }
    for (const auto& [name, value] : samples) EXPECT_TRUE(seen.contains(name)) << name << " is an option no more";
}

TEST(Options, ChangeSomethingOrAreRefused) {
    std::map<std::string, std::vector<std::string>> options;
    for (const std::string& command : commands) options[command] = options_of(command);
    std::set<std::string> effective; // "subdivide --axes": has changed something somewhere
    Compared compared;
    const std::size_t step = stride();
    std::size_t pairs = 0;
    for (const Words& line : lines()) {
        const Effect before = effect(line);
        ASSERT_EQ(before.code, 0) << testing::PrintToString(line) << before.texts.at("stderr");
        for (const std::string& option : options[line.front()]) {
            if (stands_on(line, option)) {
                effective.insert(line.front() + ' ' + option);
                continue;
            }
            if (pairs++ % step != 0) continue;
            const Effect after = effect(joined(joined(line, {option}), samples.at(option)));
            ++compared;
            if (after.code == 2) {
                EXPECT_THAT(after.texts.at("stderr"), HasSubstr("error: "));
                continue;
            }
            if (!(after == before) || may_be_idle.contains(option))
                effective.insert(line.front() + ' ' + option);
            else
                ADD_FAILURE() << option << " changes nothing in " << testing::PrintToString(line);
        }
    }
    if (!in_full()) return;
    EXPECT_GT(compared.count(), 500U);
    for (const std::string& command : commands)
        for (const std::string& option : options[command])
            EXPECT_TRUE(effective.contains(command + ' ' + option)) << command << ' ' << option << " is always refused";
}

/// Lines with options that do nothing there, and what is said of them.
TEST(Options, ThatDoNothingSayWhereTheyBelong) {
    const Workspace here;
    const Words curve{"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1"};
    const Words points{"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "1"};
    const std::vector<std::pair<Words, std::string>> cases{
        {joined(curve, {"--axes", "1,2"}), "--axes has no csv form\nhint: use SVG\n"},
        {joined(curve, {"--limit", "--format", "svg"}), "--limit has no svg form"},
        {joined(curve, {"--seed", "1"}), "--seed belongs to point grammars"},
        {joined(points, {"--tree", "--axes", "1,2"}), "--axes does nothing beside --tree"},
        {joined(points, {"--seed", "1"}), "no rule of the grammar has a weight"},
        {joined(points, {"--max-points", "9"}), "--max-points belongs to interval grammars\nhint: --max-modules"},
        {{"subdivide", "@koch", "-n", "1", "--element", "1"}, "--element belongs to a polygon"},
        {{"masks", "@fibonacci", "-d", "2", "--word", "LSL"},
         "--word belongs to --automaton, --format mtx, --format c and --format glsl"},
        {{"masks", "@fibonacci", "-d", "2", "-n", "1"}, "--steps belongs to --automaton, --format c and --format glsl"},
        {{"masks", "@fibonacci", "-d", "2", "--json", "--dot"}, "excludes"},
        {{"reverse", "@s0/13", "--rules", "--phase", "1"}, "--phase does nothing beside --rules"},
        {{"infer", "data/matrices/chaikin.csv", "--long"}, "--long belongs to --open"},
        {{"limits", "--quiet"}, "unknown option `--quiet`"},
        {{"validate", "@fibonacci", "-q"}, "unknown option `-q`"},
        {{"-q", "validate", "@fibonacci"}, "--quiet does nothing before `validate`"},
    };
    for (const auto& [line, text] : cases) {
        const Outcome outcome = here.run(line);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(line);
        EXPECT_THAT(outcome.err, HasSubstr(text)) << testing::PrintToString(line);
        EXPECT_EQ(outcome.out, "");
    }
    Words early{"--verbose"};
    early.insert(early.end(), curve.begin(), curve.end());
    EXPECT_THAT(here.run(early).err, HasSubstr("points from"));
}

} // namespace
} // namespace internode::tests
