// SPDX-License-Identifier: MIT
//
// What README shows is what the commands print. Every indented `$ internode …` is run, and the indented lines below it
// must be its output, up to a line with nothing but `…` where README leaves the rest out.

#include "tests/cli/command.h"
#include "tests/fixtures/source_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace internode::tests {
namespace {

struct Example {
    std::string command;
    std::string shown;
    bool cut = false;
};

std::vector<Example> examples() {
    std::ifstream readme(tests::in_source_folder("README.md"));
    std::vector<Example> result;
    bool inside = false;
    std::string blank;
    for (std::string line; std::getline(readme, line);) {
        if (line.rfind("    $ internode ", 0) == 0) {
            result.push_back({line.substr(16), {}, false});
            inside = true;
            blank.clear();
        } else if (inside && line.empty()) {
            blank += '\n';
        } else if (inside && line == "    …") {
            result.back().cut = true;
            inside = false;
        } else if (inside && line.rfind("    ", 0) == 0) {
            result.back().shown += blank + line.substr(4) + '\n';
            blank.clear();
        } else {
            inside = false;
        }
    }
    return result;
}

TEST(Readme, ShowsWhatTheCommandsPrint) {
    const Workspace here;
    const std::vector<Example> shown = examples();
    ASSERT_GE(shown.size(), 4U);
    for (const Example& example : shown) {
        const Outcome outcome = here.run(split(example.command));
        const std::string text = outcome.out + outcome.err;
        EXPECT_EQ(example.cut ? text.substr(0, example.shown.size()) : text, example.shown) << example.command;
        if (example.cut) {
            EXPECT_GT(text.size(), example.shown.size());
        }
    }
}

} // namespace
} // namespace internode::tests
