// SPDX-License-Identifier: MIT

#include "internode/algebra/logarithm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace internode {
namespace {

TEST(Logarithm, IsTheMathematicalFunction) {
    for (const double value : {1.0, 10.0, 1e-300, 5e-324, 1.7e308, 2.0, 3.14159, 0.1, 12345.678})
        EXPECT_NEAR(decimal_logarithm(value), std::log10(value), 1e-13) << value;
}

} // namespace
} // namespace internode
