// SPDX-License-Identifier: MIT
//
// The table of formats is what the commands do: every row is run, --format and the extension of -o agree, --help lists
// the same names.

#include "tests/cli/command.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

/// A line for each output of the table, by "command option, kind".
const std::map<std::string, Words> line_of_use{
    {"validate, interval grammars", {"validate", "@fibonacci"}},
    {"validate, point grammars", {"validate", "@s0/13"}},
    {"masks, interval grammars", {"masks", "@fibonacci", "-d", "2", "--word", "LSLLSL"}},
    {"masks --automaton, interval grammars", {"masks", "@fibonacci", "-d", "2", "--automaton"}},
    {"masks, point grammars", {"masks", "@s0/13"}},
    {"masks --automaton, point grammars", {"masks", "@s0/13", "--automaton"}},
    {"subdivide, interval grammars", {"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1"}},
    {"subdivide, grids", {"subdivide", "--u", "@fibonacci", "--v", "@silver-mean", "data/grids/wave.json", "-n", "1"}},
    {"subdivide --limit, grids",
     {"subdivide", "--u", "@fibonacci", "--v", "@silver-mean", "data/grids/wave.json", "-n", "1", "--limit"}},
    {"subdivide, point grammars", {"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "1"}},
    {"subdivide --trace, point grammars", {"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "1", "--trace"}},
    {"subdivide --tree, point grammars", {"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "1", "--tree"}},
    {"converge, interval grammars", {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1"}},
    {"converge --html, interval grammars", {"converge", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1"}},
    {"reverse, interval grammars",
     {"reverse", "@fibonacci", "data/curves/leaf.csv", "-d", "2", "--closed", "--word", "LS", "--repeat", "-n", "2"}},
    {"reverse --coarse, interval grammars",
     {"reverse", "@fibonacci", "data/curves/leaf.csv", "-d", "2", "--closed", "--word", "LS", "--repeat", "-n", "2"}},
    {"reverse --picture, interval grammars",
     {"reverse", "@fibonacci", "data/curves/leaf.csv", "-d", "2", "--closed", "--word", "LS", "--repeat", "-n", "2"}},
    {"reverse, point grammars", {"reverse", "@s0/13", "data/curves/leaf.csv", "-n", "1"}},
    {"reverse --rules, point grammars", {"reverse", "@s0/13", "--rules"}},
    {"reverse --coarse, point grammars", {"reverse", "@s0/13", "data/curves/leaf.csv", "-n", "1"}},
    {"reverse --picture, point grammars", {"reverse", "@s0/13", "data/curves/leaf.csv", "-n", "1"}},
    {"compose", {"compose", "data/pyramids/leaf.json"}},
    {"infer", {"infer", "data/matrices/chaikin.csv"}},
    {"word, interval grammars", {"word", "@fibonacci", "--word", "L", "-n", "3"}},
    {"format, interval grammars", {"format", "@fibonacci"}},
    {"format, point grammars", {"format", "@koch"}},
    {"mesh", {"mesh", "data/meshes/tetrahedron.obj"}},
    {"mesh --repair", {"mesh", "data/meshes/tetrahedron.obj", "--repair"}},
    {"formats", {"formats"}},
};

struct Row {
    std::string format;
    std::vector<std::string> extensions;
    std::vector<std::string> uses;
};

/// The rows of `internode formats`.
std::vector<Row> table() {
    std::vector<Row> rows;
    std::istringstream text(Workspace().run({"formats"}).out);
    for (std::string line; std::getline(text, line);) {
        if (line.front() == ' ') {
            rows.back().uses.push_back(line.substr(6));
            continue;
        }
        std::istringstream words(line);
        Row row;
        words >> row.format;
        for (std::string word; words >> word && word.front() == '.';) row.extensions.push_back(word);
        rows.push_back(row);
    }
    return rows;
}

/// The option of a use that names a file of its own; empty for one that changes the output.
std::string own_file(const std::string& use) {
    for (const char* option : {"--html", "--coarse", "--picture"})
        if (use.find(option) != std::string::npos) return option;
    return {};
}

/// What the command writes with --format; of --html and the like, what stands in their file.
std::string by_name(const std::string& use, const std::string& format) {
    const Workspace here;
    const Outcome outcome = here.run([&] {
        Words line = line_of_use.at(use);
        for (const std::string& word : Words{"--format", format}) line.push_back(word);
        return line;
    }());
    EXPECT_EQ(outcome.code, 0) << use << ' ' << format << '\n' << outcome.err;
    return outcome.out;
}

std::string by_extension(const std::string& use, const std::string& extension) {
    const Workspace here;
    Words line = line_of_use.at(use);
    const std::string option = own_file(use);
    for (const std::string& word : Words{option.empty() ? "-o" : option, "out" + extension}) line.push_back(word);
    const Outcome outcome = here.run(line);
    EXPECT_EQ(outcome.code, 0) << use << ' ' << extension << '\n' << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(here.path() / ("out" + extension))) << use << ' ' << extension;
    return here.read("out" + extension);
}

/// Without the command line, which stands in metadata and differs.
std::string without_metadata(std::string text) {
    for (auto at = text.find("internode "); at != std::string::npos; at = text.find("internode ", at))
        text.erase(at, text.find('\n', at) - at);
    return text;
}

TEST(Formats, EveryRowIsWritten) {
    std::set<std::string> uses;
    for (const Row& row : table())
        for (const std::string& use : row.uses) {
            uses.insert(use);
            ASSERT_TRUE(line_of_use.contains(use)) << use;
            const bool takes_word = row.format == "mtx" || row.format == "c" || row.format == "glsl";
            if (use == "masks, interval grammars" && !takes_word) continue; // below, without --word
            if (use.rfind("format,", 0) == 0) continue;                     // takes any name: a grammar is text
            for (const std::string& extension : row.extensions) {
                const std::string written = by_extension(use, extension);
                EXPECT_NE(written, "");
                if (own_file(use).empty()) {
                    EXPECT_EQ(without_metadata(written), without_metadata(by_name(use, row.format)))
                        << use << ' ' << extension;
                }
            }
        }
    EXPECT_EQ(uses.size(), line_of_use.size());
    for (const char* form : {"text", "json", "dot", "svg"})
        EXPECT_EQ(Workspace().run({"masks", "@fibonacci", "-d", "2", "--format", form}).code, 0) << form;
}

TEST(Formats, OfFilesInMemoryAreThoseOfTheirExtensionsAndOfDevicesTheUsualOne) {
    const Workspace here;
    const std::string line = "\"$INTERNODE\" subdivide @fibonacci data/curves/fibonacci-open.json -n 1 -o ";
    const Outcome device = here.shell(line + "/dev/fd/3 3>&1 >/dev/null");
    EXPECT_EQ(device.code, 0) << device.err;
    EXPECT_EQ(device.out, here.run({"subdivide", "@fibonacci", "data/curves/fibonacci-open.json", "-n", "1"}).out);
    if (!std::filesystem::is_directory("/dev/shm")) GTEST_SKIP() << "no /dev/shm here";
    const Outcome memory =
        here.shell("file=$(mktemp /dev/shm/internode.XXXXXX.npy) && " + line + "$file && cat $file; rm -f $file");
    EXPECT_EQ(memory.code, 0) << memory.err;
    EXPECT_THAT(memory.out, testing::StartsWith("\x93NUMPY"));
    const Outcome refused = here.shell(line + "/dev/shm/internode.png");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("no format for the extension `.png`"));
}

TEST(Formats, OfHelpAreThoseOfTheTable) {
    std::map<std::string, std::set<std::string>> written;
    for (const Row& row : table())
        for (const std::string& use : row.uses)
            if (own_file(use).empty()) written[use.substr(0, use.find_first_of(" ,"))].insert(row.format);
    for (const auto& [command, formats] : written) {
        const std::string help = Workspace().run({command, "--help"}).out;
        const auto begin = help.find("--format TEXT");
        ASSERT_NE(begin, std::string::npos) << help;
        for (const std::string& format : formats) EXPECT_THAT(help, HasSubstr(format)) << command;
        const Outcome other = Workspace().run({command, "--format", "png"});
        EXPECT_EQ(other.code, 2);
    }
}

TEST(Formats, EveryJsonHasASchemaAndALineInTheDocs) {
    const std::string text = content(in_source_folder("docs/json.md"));
    std::size_t schemas = 0;
    for (const auto& entry : std::filesystem::directory_iterator(in_source_folder("docs/schema"))) {
        const std::string name = entry.path().filename().string();
        EXPECT_THAT(text, HasSubstr("| `" + name + "` |"));
        EXPECT_THAT(text, HasSubstr("## internode-" + name.substr(0, name.find('.')) + "\n"));
        ++schemas;
    }
    EXPECT_GE(schemas, 14U);
}

} // namespace
} // namespace internode::tests
