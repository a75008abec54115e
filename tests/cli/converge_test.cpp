// SPDX-License-Identifier: MIT

#include "tests/cli/command.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Converge, DrawsNumbersOverTheParameter) {
    const Workspace here;
    const Outcome outcome = here.run({"converge", "@bisection", "-", "-d", "2", "--word", "A", "--repeat", "-n", "2",
                                      "-o", "report.txt", "--html", "page.html"},
                                     "x\n0\n1\n4\n9\n16\n");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = here.read("page.html");
    EXPECT_THAT(page, AllOf(HasSubstr(">parameter</text>"), HasSubstr("<g id=\"refined\">")));
    const std::string refined = page.substr(page.find("<g id=\"refined\">"));
    std::size_t dots = 0;
    for (std::size_t at = refined.find("h0"); at < refined.find("</g>"); at = refined.find("h0", at + 1)) ++dots;
    EXPECT_EQ(dots, 8U) << "the points after one step";
}

} // namespace
} // namespace internode::tests
