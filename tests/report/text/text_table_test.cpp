// SPDX-License-Identifier: MIT

#include "internode/report/text/text_table.h"

#include "internode/text/number.h"

#include "tests/report/systems.h"

namespace internode {
namespace {

TEST(TextTable, RoundsBoundsUpAndNeverBelow) {
    EXPECT_EQ(rounded_up(0), "0");
    EXPECT_EQ(rounded_up(0.25), "0.25");
    EXPECT_EQ(rounded_up(0.010252566678165872), "0.01026");
    EXPECT_EQ(rounded_up(0.99994), "1");
    EXPECT_EQ(rounded_up(1.00001e-7), "1.001e-07");
    double value = 1e-9;
    for (int i = 0; i < 1000; ++i, value *= 1.0437)
        EXPECT_GE(parse_double(rounded_up(value)).value(), value) << rounded_up(value);
}

TEST(TextTable, AlignsByCodePointsAndEndsLinesCleanly) {
    TextTable table({Align::Left, Align::Right});
    table.row({"φ", "1"}).row({"abc", "100"}).row({"x"});
    EXPECT_EQ(table.text(), "  φ      1\n  abc  100\n  x\n");
}

TEST(TextTable, KnowsWhetherItFitsAHundredColumns) {
    TextTable table({Align::Left});
    table.row({std::string(98, 'x')});
    EXPECT_TRUE(table.fits());
    table.row({std::string(99, 'x')});
    EXPECT_FALSE(table.fits());
}

TEST(TextTable, WrapsAtBlanks) {
    const std::string text = wrapped(std::string(60, 'a') + " " + std::string(60, 'b') + " c", 2);
    EXPECT_EQ(text, std::string(60, 'a') + "\n  " + std::string(60, 'b') + " c");
    EXPECT_EQ(wrapped(std::string(300, 'a'), 4), std::string(300, 'a'));
    EXPECT_EQ(wrapped("", 4), "");
}

TEST(TextTable, PutsATermThatIsNotNegativeFirst) {
    const IntervalSystem system = testing_report::system_of(testing_report::fibonacci);
    const auto text = [&](int constant, int linear, int denominator) {
        const Number number(system.field(), {Rational(constant, denominator), Rational(linear, denominator)});
        return exact_text(number, system.field(), "φ");
    };
    EXPECT_EQ(text(-3, 2, 1), "2φ−3");
    EXPECT_EQ(text(2, -1, 1), "2−φ");
    EXPECT_EQ(text(-2, -1, 1), "−φ−2");
    EXPECT_EQ(text(0, 0, 1), "0");
    EXPECT_EQ(text(7, 0, 1), "7");
    EXPECT_EQ(exact_text(Number(system.field(), {Rational(1), Rational(-1, 2)}), system.field(), "φ"), "1−φ/2");
    EXPECT_EQ(exact_text(Number(system.field(), {Rational(1, 2), Rational(3, 2)}), system.field(), "φ"), "3φ/2+1/2");
}

TEST(TextTable, LeavesOutExactTextThatIsTooLong) {
    const IntervalSystem system = testing_report::system_of(testing_report::fibonacci);
    const Number number(system.field(), {Rational("123456789012345678901"), Rational("987654321098765432101")});
    EXPECT_EQ(exact_text(number, system.field(), "φ"), "");
    EXPECT_EQ(number_text(number, system.field(), "φ").substr(0, 5), "≈ 1");
}

TEST(TextTable, WritesPolynomialsAsAReaderWould) {
    EXPECT_EQ(polynomial_text({-1, -1, 1}), "x² − x − 1");
    EXPECT_EQ(polynomial_text({-2, 1}), "x − 2");
    EXPECT_EQ(polynomial_text({2, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}), "x¹² + 3x² + 2");
    EXPECT_EQ(superscript(-17), "⁻¹⁷");
}

} // namespace
} // namespace internode
