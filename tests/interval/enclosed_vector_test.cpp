// SPDX-License-Identifier: MIT

#include "internode/interval/enclosed_vector.h"

#include "internode/interval/eigenvector.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace internode {
namespace {

SparseMatrix positive_cycle(std::mt19937& random, std::uint32_t n) {
    SparseMatrix matrix(n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j)
            if (j == (i + 1) % n || random() % 4 == 0)
                matrix[i].emplace_back(j, 1 + static_cast<std::uint32_t>(random() % 3));
    return matrix;
}

TEST(EnclosedVector, HoldsTheExactVectorClosely) {
    std::mt19937 random(7);
    for (std::uint32_t n = 2; n <= 8; ++n) {
        const SparseMatrix matrix = positive_cycle(random, n);
        const NumberField field = perron_root(matrix, 32)->field;
        std::vector<Number> exact = perron_vector(matrix, field);
        std::vector<std::uint32_t> everything(n);
        std::iota(everything.begin(), everything.end(), 0U);
        auto bounds = enclose_vector(matrix, everything);
        ASSERT_TRUE(bounds) << n;
        rescale(*bounds, 0, 1);
        for (std::uint32_t i = 0; i < n; ++i) {
            const Number ratio = exact[i] / exact[0];
            EXPECT_LE(Number((*bounds)[i].lower), ratio);
            EXPECT_GE(Number((*bounds)[i].upper), ratio);
            const Enclosure enclosure = to_enclosure((*bounds)[i]);
            EXPECT_LE(enclosure.upper - enclosure.lower, 1e-10 * enclosure.upper);
        }
    }
}

TEST(Eigenvector, ResolventSolvesItsSystemExactly) {
    // (ρI − M) x = b with ρ = √7 above the golden ratio of M = [[1, 1], [1, 0]].
    const NumberField field({-7, 0, 1}, 2, 3);
    const Number& rho = field.generator();
    const SparseMatrix matrix{{{0, 1}, {1, 1}}, {{0, 1}}};
    const std::vector<Number> b{rho / 3 + 1, Number(Rational(1, 2)) - rho};
    const std::vector<Number> x = resolvent(matrix, field, b);
    EXPECT_EQ(rho * x[0] - x[0] - x[1], b[0]);
    EXPECT_EQ(rho * x[1] - x[0], b[1]);
    const std::vector<Number> one = resolvent({{{0, 2}}}, field, {Number(1)});
    EXPECT_EQ(one[0], 1 / (rho - 2));
}

} // namespace
} // namespace internode
