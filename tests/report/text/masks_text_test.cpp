// SPDX-License-Identifier: MIT

#include "internode/report/text/masks_text.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace internode {
namespace {

using ::testing::HasSubstr;
using testing_report::system_of;

std::string text_of(const std::string& grammar, int degree) {
    return masks_text(make_mask_table(system_of(grammar), degree, WordChoice::Default, 1000));
}

TEST(MasksText, SaysThePrintedWeightsOfThePaper) {
    const std::string text = text_of(testing_report::fibonacci, 2);
    EXPECT_THAT(text, HasSubstr("φ = 1.618033988749895, the largest root of x² − x − 1"));
    EXPECT_THAT(text, HasSubstr("  *  LSL  ->  SLL  2φ−3 ≈ 0.2361\n"
                                "              LLS  1\n"
                                "              LSL  2−φ ≈ 0.382\n"));
    EXPECT_THAT(text, HasSubstr("4−2φ"));
}

TEST(MasksText, MarksOnlyPersistentWords) {
    const std::string text = text_of(testing_report::fibonacci + "axiom (S S S S S)", 2);
    EXPECT_THAT(text, HasSubstr("\n     SSS "));
    EXPECT_THAT(text, HasSubstr("\n  *  LSL "));
}

TEST(MasksText, ShowsLeadingRowsWhereThereAreEnds) {
    EXPECT_THAT(text_of("A -> A A\naxiom 0 0 A A A 0 0", 2), HasSubstr("z=1"));
    EXPECT_THAT(text_of("A -> A A", 2), ::testing::Not(HasSubstr("z=1")));
}

TEST(MasksText, FitsAHundredColumns) {
    for (const std::string& grammar : {testing_report::fibonacci, testing_report::slow_growth}) {
        for (int degree = 1; degree <= 5; ++degree) {
            std::istringstream lines(text_of(grammar, degree));
            for (std::string line; std::getline(lines, line);) {
                const auto columns = std::ranges::count_if(
                    line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
                EXPECT_LE(columns, 100) << line;
            }
        }
    }
}

TEST(MasksText, ShowsNamesWithoutObeyingThem) {
    const MaskTable table =
        make_mask_table(validate(testing_report::hostile_grammar()).system.value(), 1, WordChoice::Default, 1000);
    const std::string text = masks_text(table);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
}

} // namespace
} // namespace internode
