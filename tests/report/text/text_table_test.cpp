// SPDX-License-Identifier: MIT

#include "internode/report/text/text_table.h"

#include "internode/algebra/fraction.h"
#include "internode/text/number.h"
#include "tests/report/systems.h"

#include <gmpxx.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace internode {
namespace {

TEST(TextTable, RoundsBoundsUpAndNeverBelow) {
    EXPECT_EQ(rounded_up(0), "0");
    EXPECT_EQ(rounded_up(0.25), "0.25");
    EXPECT_EQ(rounded_up(0.010252566678165872), "0.01026");
    EXPECT_EQ(rounded_up(0.99994), "1");
    EXPECT_EQ(rounded_up(1.00001e-7), "1.001e-07");
    EXPECT_EQ(rounded_up(1.23456e307), "1.235e+307");
    EXPECT_EQ(rounded_up(std::numeric_limits<double>::max()), "1.798e+308");
    EXPECT_EQ(rounded_up(std::numeric_limits<double>::infinity()), "inf");
}

/// The number that a text like "0.01026" or "1.235e+307" stands for, and one unit of its last of four digits.
struct ShortNumber {
    mpq_class value;
    mpq_class unit;
};

mpq_class power_of_ten(long exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    return exponent < 0 ? mpq_class(mpz_class(1), power) : mpq_class(power);
}

ShortNumber short_number(const std::string& text) {
    const std::size_t mark = std::min(text.find('e'), text.size());
    std::string digits = text.substr(0, mark);
    long exponent = mark < text.size() ? std::stol(text.substr(mark + 1)) : 0;
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        exponent -= static_cast<long>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    digits.erase(0, digits.find_first_not_of('0'));
    // Zeros at the end are not written, so that the fourth digit may stand further right.
    const long missing = std::max(4 - static_cast<long>(digits.size()), 0L);
    return {mpq_class(mpz_class(digits, 10)) * power_of_ten(exponent), power_of_ten(exponent - missing)};
}

void expect_ceiling(double value) {
    const std::string text = rounded_up(value);
    const ShortNumber shown = short_number(text);
    const mpq_class exact(value);
    EXPECT_GE(shown.value, exact) << text << " for " << value;
    EXPECT_LT(shown.value - exact, shown.unit) << text << " for " << value;
    std::string digits = text.substr(0, text.find('e'));
    std::erase(digits, '.');
    digits.erase(0, digits.find_first_not_of('0'));
    EXPECT_LE(digits.size(), 4U) << text;
}

TEST(TextTable, RoundsUpExactlyOverTheWholeRangeOfDoubles) {
    std::mt19937_64 random(20261129);
    std::size_t compared = 0;
    while (compared < 20'000) {
        const double value = std::abs(std::bit_cast<double>(random()));
        if (!std::isfinite(value) || value == 0) continue;
        expect_ceiling(value);
        ++compared;
    }
}

TEST(TextTable, RoundsUpExactlyAtTheEndsOfTheRangeAndAtShortNumbers) {
    using Limits = std::numeric_limits<double>;
    for (const double value : {Limits::max(), Limits::min(), Limits::denorm_min(), 2 * Limits::denorm_min(),
                               Limits::epsilon(), 0.1, 0.3, 9999.0, 9999.5, 10000.0, 99995.0, 1e-4, 1e-5, 9.9999e-5})
        expect_ceiling(value);
    std::mt19937_64 random(7);
    for (int i = 0; i < 5'000; ++i) {
        expect_ceiling(static_cast<double>((random() >> 12) | 1) * Limits::denorm_min());
        const auto digits = static_cast<double>(random() % 9000 + 1000);
        expect_ceiling(digits * std::ldexp(1.0, static_cast<int>(random() % 40) - 20));
        expect_ceiling(std::nextafter(digits / 1000, random() % 2 == 0 ? 0.0 : 10.0));
    }
}

/// Where rounding to the nearest goes up, both write the same characters.
TEST(TextTable, RoundsUpInTheSameFormAsToTheNearest) {
    std::mt19937_64 random(8);
    std::size_t compared = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double value =
            static_cast<double>(random() >> 11) * std::ldexp(1.0, static_cast<int>(random() % 120) - 113);
        if (value == 0 || short_number(rounded(value)).value < mpq_class(value)) continue;
        EXPECT_EQ(rounded_up(value), rounded(value));
        ++compared;
    }
    EXPECT_GT(compared, 5'000U);
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
    const std::string first(60, 'a');
    const std::string second(60, 'b');
    EXPECT_EQ(wrapped(first + " " + second + " c", 2), first + "\n  " + second + " c");
    EXPECT_EQ(wrapped(std::string(300, 'a'), 4), std::string(300, 'a'));
    EXPECT_EQ(wrapped("", 4), "");
}

TEST(TextTable, PutsATermThatIsNotNegativeFirst) {
    const IntervalSystem system = testing_report::system_of(testing_report::fibonacci);
    const auto text = [&](int constant, int linear, int denominator) {
        const Number number(system.field(), {fraction(constant, denominator), fraction(linear, denominator)});
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
