// SPDX-License-Identifier: MIT
//
// Every error has a code, every code an example that provokes it, and the page shows them all.

#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"
#include "tests/grammar/error_examples.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

namespace internode {

namespace {

using tests::content;
using tests::ErrorExample;

/// The codes that stand in the sources of the room: literals such as "grammar.no-rule".
std::set<std::string> codes_in_the_source() {
    std::set<std::string> codes;
    const std::regex code("\"([a-z0-9]+\\.[a-z0-9-]+)\"");
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(tests::in_source_folder("lib/internode/grammar"))) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = content(entry.path());
        for (auto found = std::sregex_iterator(text.begin(), text.end(), code); found != std::sregex_iterator();
             ++found)
            codes.insert((*found)[1]);
    }
    return codes;
}

constexpr std::string_view begin_mark = "<!-- every error: written by the test ErrorCode.ThePageShowsEveryError -->\n";
constexpr std::string_view end_mark = "<!-- end of every error -->\n";

struct Page {
    std::string before; ///< up to the section and its mark
    std::string section;
    std::string after;
};

Page read_page(const std::filesystem::path& path) {
    const std::string text = content(path);
    const std::size_t begin = text.find(begin_mark);
    const std::size_t end = text.find(end_mark);
    if (begin == std::string::npos || end == std::string::npos) return {text, {}, {}};
    const std::size_t first = begin + begin_mark.size();
    return {text.substr(0, first), text.substr(first, end - first), text.substr(end)};
}

} // namespace

TEST(ErrorCode, EveryCodeOfTheSourceHasOneExample) {
    std::set<std::string> shown;
    for (const ErrorExample& example : tests::error_examples())
        EXPECT_TRUE(shown.emplace(example.code).second) << example.code << " has two";
    EXPECT_THAT(shown, testing::ContainerEq(codes_in_the_source()));
    EXPECT_GE(shown.size(), 140u);
}

/// With INTERNODE_WRITE_PAGES=1 in the environment it writes the section instead. One test: the texts are read once.
TEST(ErrorCode, ThePageShowsEveryError) {
    for (const ErrorExample& example : tests::error_examples()) {
        const std::vector<Diagnostic>& errors = tests::errors_of(example);
        const auto has_code = [&](const Diagnostic& error) { return error.code == example.code; };
        EXPECT_TRUE(std::ranges::any_of(errors, has_code)) << example.code << " is not among\n" << to_string(errors);
        for (const Diagnostic& error : errors) EXPECT_NE(error.code, "") << error.message;
    }
    const std::filesystem::path path = tests::in_source_folder("docs/language.md");
    const Page page = read_page(path);
    ASSERT_FALSE(page.after.empty()) << "the page has no marks";
    if (std::getenv("INTERNODE_WRITE_PAGES") != nullptr) {
        std::ofstream(path) << page.before << tests::error_page() << page.after;
        return;
    }
    EXPECT_EQ(page.section, tests::error_page()) << "INTERNODE_WRITE_PAGES=1 writes it";
}

} // namespace internode
