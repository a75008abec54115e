// SPDX-License-Identifier: MIT
//
// Every limit that refuses is printed by `internode limits`. The constants called max_… are looked up in the sources,
// and each must stand in the table with its number, or below among those that refuse nothing, with the reason.

#include "internode/stencil/kernel.h"
#include "tests/cli/command.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace internode::tests {
namespace {

using testing::HasSubstr;

/// Constants that refuse nothing.
const std::map<std::string, std::string> refuse_nothing{
    {"max_arity", "a wider mask has no twin among interval grammars: the command says nothing of one"},
    {"max_bytes", "a longer comment is cut"},
    {"max_texts", "deeper calls stay unproved, and `validate` says so"},
    {"max_centre", "bounds of the radius stay as far apart as they are"},
    {"max_coefficients", "bounds of the radius stay as far apart as they are"},
    {"max_bits", "bounds of the radius stay as far apart as they are"},
    {"max_compiled_cycles", "more cycles are derived module by module"},
    {"max_contexts", "coverage looks no further, and `validate` says so"},
    {"max_depth", "more steps for a tolerance are told as none; deeper constants are not folded"},
    {"max_explored_modules", "coverage looks no further, and `validate` says so"},
    {"max_explored_work", "coverage looks no further, and `validate` says so"},
    {"max_instructions", "a longer expression stays unproved, and `validate` says so"},
    {"max_kept_name", "a longer name of a temporary file is cut"},
    {"max_legend_entries", "a longer legend ends with how many are left out"},
    {"max_links", "the limit of the kernel, which says so itself"},
    {"max_listed_shifts", "a longer list of shifts is cut"},
    {"max_matrix", "bounds of the radius stay as far apart as they are"},
    {"max_name", "a longer name of a variable stays unproved"},
    {"max_products", "bounds of the radius stay as far apart as they are"},
    {"max_reach", "coverage looks no further, and `validate` says so"},
    {"max_row_width", "degree 12 and 1"},
    {"max_smoothness_arity", "smoothness is left out, and `validate` says so"},
    {"max_smoothness_coefficients", "smoothness is left out, and `validate` says so"},
    {"max_spectral_bits", "bounds of the radius stay as far apart as they are"},
    {"max_steps", "bounds of the radius stay as far apart as they are"},
    {"max_threads", "more threads are as many"},
    {"max_validated_coefficients", "smoothness is left out, and `validate` says so"},
    {"max_visits", "a length that is not known beforehand"},
    {"max_work", "a longer proof is given up, and `validate` says so"},
};

/// "16777216" of "std::size_t{16} << 20"; empty for what is no number.
std::string value_of(std::string text) {
    text = std::regex_replace(text, std::regex("'|std::u?int\\d+_t|std::size_t"), "");
    std::smatch parts;
    const std::regex number(R"(\s*\(?\{?(\d+)\}?(?:\s*<<\s*(\d+)U?)?\)?(\s*-\s*1)?\s*)");
    if (!std::regex_match(text, parts, number)) return {};
    std::uint64_t value = std::stoull(parts[1]);
    if (parts[2].matched) value <<= std::stoull(parts[2]);
    return std::to_string(value - (parts[3].matched ? 1 : 0));
}

struct Constant {
    std::string name;
    std::string value; ///< empty when it is computed
    std::string file;
};

std::vector<Constant> read_constants() {
    const std::regex declaration(R"(constexpr\s+[\w:]+\s+(max_\w+)\s*=\s*([^;]+);)");
    std::vector<Constant> found;
    for (const char* folder : {"lib", "cli"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(in_source_folder(folder))) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            const std::string text = content(entry.path());
            for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
                found.push_back({(*at)[1], value_of((*at)[2]), entry.path().filename().string()});
        }
    return found;
}

/// Read once: the sources are many.
const std::vector<Constant>& constants() {
    static const std::vector<Constant> all = read_constants();
    return all;
}

/// The numbers of the table, as they stand there.
std::set<std::string> printed() {
    std::set<std::string> numbers;
    std::istringstream lines(Workspace().run({"limits"}).out);
    const std::regex row(R"(^.{58}.*? +(\d+) .*$)");
    std::smatch parts;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, parts, row)) numbers.insert(parts[1]);
    return numbers;
}

TEST(Limits, EveryConstantThatRefusesIsPrinted) {
    const std::set<std::string> numbers = printed();
    ASSERT_GT(numbers.size(), 20U);
    const std::vector<Constant>& all = constants();
    ASSERT_GT(all.size(), 60U);
    for (const Constant& constant : all) {
        if (refuse_nothing.contains(constant.name)) continue;
        if (constant.value.empty()) continue; // computed from others, which stand here
        EXPECT_TRUE(numbers.contains(constant.value))
            << constant.name << " = " << constant.value << " of " << constant.file;
    }
}

TEST(Limits, WhatRefusesNothingIsStillThere) {
    std::set<std::string> names;
    for (const Constant& constant : constants()) names.insert(constant.name);
    for (const auto& [name, reason] : refuse_nothing) EXPECT_TRUE(names.contains(name)) << name << ": " << reason;
}

TEST(Limits, ARefusalOfSizeIsNoBug) {
    const Outcome words = Workspace().run({"masks", "@tribonacci", "-d", "12", "--all"});
    EXPECT_EQ(words.code, 3);
    EXPECT_EQ(words.err, "error: more than 200000 words\n");
    EXPECT_EQ(words.out, "");
}

TEST(Limits, OfTheCommandAreRefusedWithTheirNumber) {
    const Workspace here;
    const std::string leaf = "data/curves/leaf.csv";
    EXPECT_THAT(here.run({"reverse", "@fibonacci", leaf, "-d", "2", "--closed", "--word", "LS", "-n", "100001"}).err,
                HasSubstr("100000 levels"));
    EXPECT_THAT(here.run({"reverse", "@s0/38", leaf, "-n", "100001"}).err, HasSubstr("100000 levels"));
    EXPECT_THAT(here.run({"subdivide", "@s0/38", leaf, "-n", "100001"}).err, HasSubstr("100000 cycles"));
    EXPECT_THAT(here.run({"masks", "@s0/22", "--points", "100001"}).err, HasSubstr("from 1 to 100000"));
    std::string rows;
    for (int row = 0; row < 4 * 65; ++row)
        rows += std::vector<std::string>{"1,0,0,0\n", "0,1,0,0\n", "0,0,1,0\n", "0,0,0,1\n"}[row / 65];
    const Outcome wide = here.run({"infer", here.file("wide.csv", rows)});
    EXPECT_EQ(wide.code, 3);
    EXPECT_THAT(wide.err, HasSubstr("64 new points"));
}

} // namespace
} // namespace internode::tests
