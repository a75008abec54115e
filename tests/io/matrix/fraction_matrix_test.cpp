// SPDX-License-Identifier: MIT

#include "internode/io/matrix/fraction_matrix.h"

#include "internode/io/csv.h"
#include "internode/io/file/limits.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

RationalMatrix read(std::string_view text) {
    ParsedFractionMatrix parsed = read_fraction_matrix(text, "m");
    EXPECT_TRUE(parsed.matrix) << text << '\n' << to_string(parsed.errors);
    return parsed.matrix ? *std::move(parsed.matrix) : RationalMatrix();
}

Diagnostic refusal(std::string_view text) {
    const ParsedFractionMatrix parsed = read_fraction_matrix(text, "m");
    EXPECT_FALSE(parsed.matrix) << text;
    return parsed.errors.empty() ? Diagnostic{} : parsed.errors.front();
}

std::string place(const Diagnostic& diagnostic) {
    return std::to_string(diagnostic.line) + ':' + std::to_string(diagnostic.column);
}

const RationalMatrix small{3, {{{0, Rational(3, 4)}, {1, Rational(1, 4)}}, {{1, Rational(-1)}, {2, Rational(1, 2)}}}};

TEST(FractionMatrix, ReadsFractionsAndDecimalsExactly) {
    EXPECT_EQ(read("3/4, 1/4, 0\n0, -1, 1/2\n"), small);
    EXPECT_EQ(read("0.75, .25, 0\n0, -1.0, 5e-1"), small);
    EXPECT_EQ(read("6/8,+1/4,0\n0,-1.,0.5"), small);
    EXPECT_EQ(read("1/3\n").rows[0][0].value, Rational(1, 3));
}

TEST(FractionMatrix, TakesTheSeparatorOfTheFirstRow) {
    EXPECT_EQ(read("3/4; 1/4; 0\n0;-1;1/2"), small);
    EXPECT_EQ(read("3/4\t1/4\t0\n0\t-1\t1/2\n"), small);
    EXPECT_EQ(read("  3/4 1/4   0 \n 0 -1\t1/2\n"), small);
    const Diagnostic error = refusal("1, 2\n3; 4\n");
    EXPECT_EQ(place(error), "2:1");
    EXPECT_THAT(error.hint, HasSubstr("`,`"));
}

TEST(FractionMatrix, PassesOverCommentsBlankLinesAndLineEnds) {
    EXPECT_EQ(read("\xEF\xBB\xBF# Chaikin\r\n\r\n3/4, 1/4, 0 # the first row\r\n\n0, -1, 1/2"), small);
}

TEST(FractionMatrix, ReportsDotsWithTheirPlaces) {
    for (const char* dots : {"...", ":", "\u22EE", "\u22F1", "..", "\u2026", "\u22EE\u22EE", "."}) {
        const Diagnostic error = refusal("1, 0\n1/2, " + std::string(dots) + "\n0, 1\n");
        EXPECT_EQ(place(error), "2:6") << dots;
        EXPECT_THAT(error.message, HasSubstr("cannot be interpreted")) << dots;
    }
    EXPECT_EQ(place(refusal("1 0 0\n: : :\n0 0 1")), "2:1");
    EXPECT_EQ(place(refusal("...\n1, 2")), "1:1");
    EXPECT_THAT(read_fraction_csv("1 0\n: :\n0 1\n. .", "m").errors, SizeIs(2)) << "each line once";
}

TEST(FractionMatrix, DotsBesideADigitAreNone) {
    for (const char* text : {"1:", ":1", "1..", "..1", "1\u2026", "\u2026/1"}) {
        const Diagnostic error = refusal("1, 0\n1/2, " + std::string(text) + "\n0, 1\n");
        EXPECT_EQ(place(error), "2:6") << text;
        EXPECT_THAT(error.message, HasSubstr("is neither a fraction nor a decimal number")) << text;
    }
}

TEST(FractionMatrix, ComplainsAtThePlace) {
    EXPECT_EQ(place(refusal("1, 2\n3, x\n")), "2:4");
    EXPECT_EQ(place(refusal("1, 2\n3, \n")), "2:4");
    EXPECT_EQ(place(refusal("1, 2\n3, 1/0\n")), "2:4");
    EXPECT_EQ(place(refusal("1, 2\n3\n")), "2:1");
    EXPECT_THAT(refusal("1, 2\n3\n").message, HasSubstr("1 entry, but the first row has 2"));
    EXPECT_THAT(refusal("").message, HasSubstr("no row"));
    EXPECT_THAT(refusal("# nothing\n\n").message, HasSubstr("no row"));
    std::string many = "1,1\n";
    for (int i = 0; i < 200; ++i) many += "1,x\n";
    EXPECT_THAT(read_fraction_csv(many, "m").errors, SizeIs(max_polygon_errors));
}

TEST(FractionMatrix, ReadsEveryFormOfMatrixMarket) {
    EXPECT_EQ(read("%%MatrixMarket matrix coordinate real general\n% comment\n2 3 4\n"
                   "1 1 0.75\n2 3 1/2\n1 2 2.5e-1\n\n2 2 -1\n"),
              small);
    EXPECT_EQ(read("%%matrixmarket MATRIX array REAL general\n2 3\n3/4\n0\n1/4\n-1\n0\n1/2\n"), small);
    const RationalMatrix symmetric{2, {{{0, 1}, {1, 2}}, {{0, 2}, {1, 3}}}};
    EXPECT_EQ(read("%%MatrixMarket matrix coordinate integer symmetric\n2 2 3\n1 1 1\n2 1 2\n2 2 3\n"), symmetric);
    EXPECT_EQ(read("%%MatrixMarket matrix array integer symmetric\n2 2\n1\n2\n3\n"), symmetric);
    EXPECT_EQ(read("%%MatrixMarket matrix coordinate real general\n1 2 0\n"), (RationalMatrix{2, {{}}}));
}

TEST(FractionMatrix, RefusesDamagedMatrixMarket) {
    const std::string banner = "%%MatrixMarket matrix coordinate real general\n";
    EXPECT_EQ(place(refusal("%%MatrixMarket tensor coordinate real general\n")), "1:1");
    EXPECT_EQ(place(refusal("%%MatrixMarket matrix coordinate complex general\n")), "1:34");
    EXPECT_EQ(place(refusal("%%MatrixMarket matrix coordinate real hermitian\n")), "1:39");
    EXPECT_THAT(refusal(banner).message, HasSubstr("no line with the sizes"));
    EXPECT_EQ(place(refusal(banner + "2 2\n")), "2:1");
    EXPECT_EQ(place(refusal(banner + "2 0 1\n")), "2:3");
    EXPECT_THAT(refusal(banner + "2 2 1\n").message, HasSubstr("0 entries, but 1 are announced"));
    EXPECT_EQ(place(refusal(banner + "2 2 1\n1 1 1\n2 2 1\n")), "4:1");
    EXPECT_EQ(place(refusal(banner + "2 2 1\n1 3 1\n")), "3:3");
    EXPECT_EQ(place(refusal(banner + "2 2 1\n0 1 1\n")), "3:1");
    EXPECT_EQ(place(refusal(banner + "2 2 1\n1 1\n")), "3:3");
    EXPECT_EQ(place(refusal(banner + "2 2 2\n1 1 1\n:\n")), "4:1");
    EXPECT_THAT(refusal(banner + "2 2 2\n1 1 1\n1 1 2\n").message, HasSubstr("two entries in column 1"));
    EXPECT_EQ(place(refusal("%%MatrixMarket matrix array real symmetric\n2 3\n")), "2:3");
    EXPECT_EQ(place(refusal("%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 2 1\n")), "3:3");
}

TEST(FractionMatrix, TrustsNoCount) {
    const std::string banner = "%%MatrixMarket matrix coordinate real general\n";
    for (const char* sizes : {"18446744073709551615 1 1", "1000001 1 1", "1 1 99999999999", "-1 1 1", "1 1 1e3"})
        EXPECT_EQ(refusal(banner + sizes + "\n1 1 1\n").line, 2U) << sizes;
    EXPECT_THAT(refusal("%%MatrixMarket matrix array real general\n1000000 1000000\n1\n").message,
                HasSubstr("1 entries, but 1000000000000"));
    std::string wide;
    for (std::size_t i = 0; i <= max_matrix_side; ++i) wide += "0 ";
    EXPECT_THAT(refusal(wide).message, HasSubstr("1000000 columns"));
}

TEST(FractionMatrix, RefusesTheFirstEntryBeyondTheLimitWithoutItsZeros) {
    constexpr std::uint64_t columns = 1'000;
    const std::string ones = tests::repeated("1 ", columns) + '\n';
    const std::string zeros = tests::repeated("0 ", columns) + '\n';
    const std::string last = "0 1 " + tests::repeated("0 ", columns - 2) + '\n';
    const std::string most = zeros + tests::repeated(ones, max_matrix_entries / columns);
    const Diagnostic error = refusal(most + last + last);
    EXPECT_EQ(place(error), "2002:3");
    EXPECT_EQ(error.message, "more than 2000000 entries that are not 0, the limit");
}

TEST(FractionMatrix, RefusesTheFirstEntryBeyondTheLimitOfASymmetricMatrix) {
    const std::string head = "%%MatrixMarket matrix coordinate integer symmetric\n2 2 1000001\n";
    const Diagnostic error = refusal(head + tests::repeated("2 1 1\n", max_matrix_entries / 2 + 1));
    EXPECT_EQ(place(error), "1000003:1");
    EXPECT_EQ(error.message, "more than 2000000 entries, the limit");
}

TEST(FractionMatrix, EveryPrefixAndEveryDamagedByteIsReadOrRefused) {
    const std::string texts[] = {
        "# m\r\n3/4, 1/4, 0\n0, -1, 5e-1 # end\n...\n",
        "%%MatrixMarket matrix coordinate real symmetric\n% c\n3 3 3\n1 1 1/2\n2 1 -.5\n3 3 1e1\n",
        "%%MatrixMarket matrix array integer general\n2 2\n1\n2\n3\n4\n"};
    for (const std::string& text : texts) {
        for (std::size_t length = 0; length <= text.size(); ++length) {
            const ParsedFractionMatrix parsed = read_fraction_matrix(text.substr(0, length), "m");
            EXPECT_EQ(parsed.matrix.has_value(), parsed.errors.empty());
        }
        for (std::size_t at = 0; at < text.size(); ++at)
            for (const char damage : {'\0', '\xFF', '9', '/', '.', ' ', '\n', '-', '%', ';'}) {
                std::string damaged = text;
                damaged[at] = damage;
                const ParsedFractionMatrix parsed = read_fraction_matrix(damaged, "m");
                EXPECT_EQ(parsed.matrix.has_value(), parsed.errors.empty());
            }
    }
}

TEST(FractionMatrix, IsReadBackAsWritten) {
    StringSink sink;
    ASSERT_TRUE(write_fraction_csv(sink, small));
    EXPECT_EQ(sink.text(), "3/4, 1/4, 0\n0, -1, 1/2\n");
    EXPECT_EQ(read(sink.text()), small);
}

} // namespace
} // namespace internode
