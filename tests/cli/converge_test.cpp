// SPDX-License-Identifier: MIT

#include "tests/cli/command.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Converge, DrawsNumbersAgainstThemselves) {
    const Workspace here;
    const Outcome one = here.run(
        {"converge", "@bisection", "-", "-d", "2", "--word", "A", "--repeat", "-n", "2", "--html", "page.html"},
        "x\n0\n1\n4\n9\n16\n");
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_THAT(here.read("page.html"), AllOf(HasSubstr("<svg"), HasSubstr("</html>")));
}

} // namespace
} // namespace internode::tests
