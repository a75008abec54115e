// SPDX-License-Identifier: MIT

#include "internode/report/markup.h"

#include "tests/report/systems.h"

namespace internode {
namespace {

TEST(Markup, LeavesPlainTextAlone) {
    EXPECT_EQ(markup("A1 → φ²"), "A1 → φ²");
    EXPECT_EQ(dot_quoted("A1 → φ²"), "\"A1 → φ²\"");
}

TEST(Markup, TurnsEveryCharacterOfMarkupIntoAnEntity) {
    EXPECT_EQ(markup("<a href='x'>&\"</a>"), "&lt;a href=&#39;x&#39;&gt;&amp;&quot;&lt;/a&gt;");
}

TEST(Markup, ShowsControlsAndOverridesAndBrokenBytes) {
    testing_report::expect_inert(markup(testing_report::hostile));
    for (int byte = 0; byte < 32; ++byte) {
        const std::string shown = markup(std::string(1, static_cast<char>(byte)));
        for (const char c : shown) EXPECT_GE(static_cast<unsigned char>(c), 32U) << byte;
    }
}

TEST(Markup, LeavesDotNothingToInterpret) {
    const std::string quoted = dot_quoted("a\"b\\N\\\"];evil");
    EXPECT_EQ(quoted, "\"a&quot;b&#92;N&#92;&quot;];evil\"");
    testing_report::expect_inert(dot_quoted(testing_report::hostile));
}

} // namespace
} // namespace internode
