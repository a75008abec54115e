// SPDX-License-Identifier: MIT

#include "internode/point/infer/reduction.h"

#include "internode/point/infer/reversal.h"
#include "tests/point/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const PointSettings on_a_line{.dimension = 1, .constants = {}, .start = PointStart::Input};

TEST(Reduction, OfPairsToTheirMeans) {
    const PointSystem system = point_system("points\nring\nP(u) P(v) -> P(1/2 u + 1/2 v)\n", on_a_line);
    const std::vector<double> points{0, 2, 4, 6, 8, 10, 12, 14};
    const Reduction down = reduced(system, points, 3, 0);
    EXPECT_FALSE(down.problem);
    EXPECT_THAT(down.polygons, ElementsAre(ElementsAre(1, 5, 9, 13), ElementsAre(3, 11), ElementsAre(7)));
    EXPECT_THAT(reduced(system, points, 1, 1).polygons, ElementsAre(ElementsAre(3, 7, 11, 7)));
    EXPECT_THAT(reduced(system, points, 1, 9).polygons, ElementsAre(ElementsAre(3, 7, 11, 7))) << "round the ring";
    EXPECT_THAT(reduced(system, points, 0, 0).polygons, IsEmpty());
}

TEST(Reduction, EndsWithItsProblem) {
    const PointSystem system = point_system("points\nring\nP(u) P(v) -> P(1/2 u + 1/2 v)\n", on_a_line);
    const Reduction down = reduced(system, std::vector<double>{0, 2, 4, 6, 8, 10}, 3, 0);
    EXPECT_TRUE(down.problem) << "three points are no pairs";
    EXPECT_THAT(down.polygons, ElementsAre(ElementsAre(1, 5, 9)));
}

TEST(Reduction, EndsWhereNoPointIsLeft) {
    const PointSystem system = point_system("points\nring\nP(u) P(v) -> E\nE -> E\n", on_a_line);
    EXPECT_THAT(reduced(system, std::vector<double>{0, 2, 4, 6}, 5, 0).polygons, ElementsAre(IsEmpty()));
    const PointSystem later = point_system("points\nring\nP(u) P(v) -> Q(u)\nQ(u) Q(v) -> E\nE -> E\n", on_a_line);
    EXPECT_THAT(reduced(later, std::vector<double>{0, 2, 4, 6}, 5, 0).polygons,
                ElementsAre(ElementsAre(0, 4), IsEmpty()));
}

TEST(Reduction, TellsHowManyBecomeOne) {
    const auto grammar = [](const std::string& rules) { return point_grammar("points\nring\n" + rules); };
    EXPECT_TRUE(reduces(grammar("P(u) P(v) P(w) -> P(u)\n")));
    EXPECT_EQ(reduced_arity(grammar("P(u) P(v) P(w) -> P(u)\n")), 3U);
    EXPECT_FALSE(reduces(grammar("P(u) -> P(u) P(u)\n")));
    EXPECT_EQ(reduced_arity(grammar("P(u) P(v) -> P(u)\nQ(u) -> Q(u)\n")), 1U) << "of different numbers";
    EXPECT_EQ(reduced_arity(grammar("P(u) P(v) -> P(u) P(v)\n")), 1U);
}

TEST(RingSizes, AreTheMultiplesRoundTheMeasuredNumber) {
    for (std::size_t arity = 1; arity <= 4; ++arity)
        for (std::uint64_t levels = 0; levels <= 3; ++levels)
            for (std::uint64_t points = 1; points <= 80; ++points) {
                const std::uint64_t factor = points_per_coarse_point(arity, levels).value();
                std::uint64_t below = points;
                while (below > 0 && below % factor != 0) --below;
                const RingSizes sizes = ring_sizes(points, arity, levels);
                ASSERT_EQ(sizes.below, below);
                ASSERT_EQ(sizes.above, below + factor);
                ASSERT_EQ(sizes.exact(), points % factor == 0);
                ASSERT_TRUE(sizes.nearest() == below || sizes.nearest() == below + factor);
                ASSERT_GT(sizes.nearest(), 0U);
                if (below == 0) continue;
                ASSERT_EQ(sizes.nearest() == below, 2 * (points - below) <= factor);
            }
}

TEST(RingSizes, AreNoneWhereTheLevelsAreTooMany) {
    const RingSizes none = ring_sizes(12, 3, 100);
    EXPECT_FALSE(none.exact());
    EXPECT_EQ(none.nearest(), 0U);
}

} // namespace
} // namespace internode
