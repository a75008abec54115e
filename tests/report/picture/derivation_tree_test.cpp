// SPDX-License-Identifier: MIT

#include "internode/report/picture/derivation_tree.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/point/start_word.h"
#include "tests/fixtures/point_systems.h"
#include "tests/report/picture/trees.h"

#include <gmock/gmock.h>

#include <regex>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_report::tree_of;
using tests::point_system;

std::size_t occurrences(const std::string& text, const std::string& what) {
    const std::regex pattern(what);
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()));
}

std::string layer(const std::string& svg, const std::string& id) {
    const std::size_t start = svg.find("<g id=\"" + id + "\"");
    return svg.substr(start, svg.find("</g>", start) - start);
}

/// S1, figure 5a, for three points: five modules, then three, then the one.
constexpr std::string_view de_casteljau = "points d\naxiom P((0,0)) E P((1,2)) E P((2,0))\n"
                                          "P(u) < E > P(v) -> P(1/2 u + 1/2 v)\nE < P(v) > E -> E\nP(v) -> .\n";

TEST(DerivationTree, OfDeCasteljauIsThatOfFigureFive) {
    const PointSystem system = point_system(de_casteljau);
    const std::string svg = derivation_tree(tree_of(system, 2), system);
    EXPECT_EQ(occurrences(svg, "<circle cx=\"[0-9.]*\" cy=\"[0-9.]*\" r=\"6.5\""), 3U + 2 + 1);
    EXPECT_EQ(occurrences(layer(svg, "successors"), "<path"), 3U + 1);
    EXPECT_EQ(occurrences(layer(svg, "contexts"), "<path"), 4U + 2) << "each new point reads two points";
    EXPECT_THAT(svg, HasSubstr(">E</text>"));
}

TEST(DerivationTree, NumbersStandBesideTheirModules) {
    const PointSystem system = point_system("points n\naxiom A(1.5)\nA(x) -> A(2 x + 1)\n");
    EXPECT_THAT(derivation_tree(tree_of(system, 1), system), HasSubstr(">A(4)</text>"));
}

TEST(DerivationTree, TheKeyNamesNumbersByTheirPlace) {
    const PointSystem system = point_system("points n\naxiom A(1, 2, 3, 4, 5)\nA(a, b, c, d, e) -> A(b, c, d, e, a)\n");
    EXPECT_THAT(derivation_tree(tree_of(system, 1), system), HasSubstr(">A(x, y, z, x4, x5)</text>"));
}

TEST(DerivationTree, StatesHaveColoursOfTheirOwn) {
    const PointSystem system = point_system("points s\naxiom P((0,0), 2) P((1,0), 0)\nP(v, s) -> P(v, s)\n");
    const std::string svg = derivation_tree(tree_of(system, 1), system);
    EXPECT_THAT(svg, HasSubstr(">P(v, 2)</text>"));
    EXPECT_THAT(svg, HasSubstr(">P(v, 0)</text>"));
}

TEST(DerivationTree, NamesAreText) {
    const PointSystem system = point_system(de_casteljau);
    DerivationTree tree = tree_of(system, 1);
    tree.title = "<script>";
    tree.row_names[0] = "<b>";
    const std::string svg = derivation_tree(tree, system);
    EXPECT_THAT(svg, Not(HasSubstr("<script>")));
    EXPECT_THAT(svg, Not(HasSubstr("<b>")));
}

TEST(DerivationTree, RefusesWhatDoesNotFit) {
    const PointSystem system = point_system(de_casteljau);
    DerivationTree tree = tree_of(system, 1);
    tree.row_names.pop_back();
    EXPECT_THROW((void)derivation_tree(tree, system), std::invalid_argument);
    tree = tree_of(system, 0);
    for (std::size_t i = 0; i <= max_tree_row; ++i) tree.words[0].push_back(tree.words[0].letter(1), {});
    EXPECT_FALSE(fits_in_tree(tree.words));
    EXPECT_THROW((void)derivation_tree(tree, system), std::invalid_argument);
}

} // namespace
} // namespace internode
