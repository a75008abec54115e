// SPDX-License-Identifier: MIT
//
// reverse and compose: which polygons fit, what is done to those that do not, and the way there and back.

#include "tests/cli/command.h"

#include "internode/text/number.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string leaf = "data/curves/leaf.csv"; // 20 points, closed

class Reverse : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"reverse", "@fibonacci"});
        return here.run(arguments);
    }
    /// The numbers of a CSV with a header.
    static std::vector<double> numbers(const std::string& csv) {
        std::vector<double> values;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < csv.size(); ++i) {
            if (csv[i] != ',' && csv[i] != '\n') continue;
            if (const auto value = parse_double(csv.substr(begin, i - begin))) values.push_back(*value);
            begin = i + 1;
        }
        return values;
    }
    static double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
        if (a.size() != b.size()) return 1e300;
        double most = 0;
        for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
        return most;
    }
    Workspace here;
};

TEST_F(Reverse, AndComposeGiveThePolygonBack) {
    for (const char* const method : {"--quiet", "--local"}) {
        ASSERT_EQ(
            run({leaf, "-d", "3", "-n", "2", "--closed", method, "--word", "LS", "--repeat", "-o", "p.json"}).code, 0);
        const Outcome composed = here.run({"compose", "p.json"});
        EXPECT_EQ(composed.code, 0) << composed.err;
        EXPECT_LT(largest_difference(numbers(composed.out), numbers(here.read(leaf))), 1e-12);
    }
}

TEST_F(Reverse, UndoesSubdivide) {
    ASSERT_EQ(here.run({"subdivide", "@fibonacci", leaf, "-d", "3", "-n", "3", "--closed", "--word", "LSLLS",
                        "--repeat", "-o", "fine.json"})
                  .code,
              0);
    const Outcome outcome =
        run({"fine.json", "-n", "3", "--word", "LSLLS", "--repeat", "--coarse", "coarse.json", "--threshold", "1e-9"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("0 of"));
    const Outcome coarse = here.run({"subdivide", "@fibonacci", "coarse.json", "-n", "0"});
    EXPECT_LT(largest_difference(numbers(coarse.out), numbers(here.read(leaf))), 1e-12);
    EXPECT_EQ(run({"fine.json", "-n", "3", "--word", "SL", "--repeat"}).code, 3);
    EXPECT_EQ(run({"fine.json", "-n", "3", "--word", "SLLSL", "--repeat", "--resample"}).code, 3);
}

TEST_F(Reverse, FindsTheLevelsOfAGivenWord) {
    const Outcome outcome = run({leaf, "-d", "2", "--closed", "--word", "LSLS LSLS"}); // 8, 12, 20 points
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("2 levels down"));
    EXPECT_EQ(run({leaf, "-d", "2", "--closed", "--word", "LS", "--repeat"}).code, 2);
}

TEST_F(Reverse, SaysHowAPolygonWasMadeToFit) {
    const std::vector<std::string> common{leaf, "-d", "3", "-n", "3", "--closed", "--word", "LS", "--repeat"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), common.begin(), common.end());
        return run(more);
    };
    const Outcome refused = with({});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("20 points"), HasSubstr("16 below"), HasSubstr("21 above")));
    EXPECT_THAT(with({"--cut"}).out, HasSubstr("20 points, the last 4 cut off: 16"));
    EXPECT_THAT(with({"--resample"}).out, HasSubstr("20 points, resampled to 21 at equal steps of chord length"));
    const Outcome quiet = with({"--resample", "--json"});
    EXPECT_THAT(quiet.err, HasSubstr("resampled to 21"));
    EXPECT_THAT(quiet.out, HasSubstr(R"("change": "resampled")"));
    EXPECT_EQ(with({"--resample", "--json", "-q"}).err, "");
}

TEST_F(Reverse, KeepsTheDetailsAskedFor) {
    const std::vector<std::string> common{leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--repeat"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), common.begin(), common.end());
        return run(more).out;
    };
    EXPECT_THAT(with({}), HasSubstr("12 of 12 details kept, 20 of 20 vectors"));
    EXPECT_THAT(with({"--keep", "5"}), HasSubstr("5 of 12 details kept, 13 of 20 vectors"));
    EXPECT_THAT(with({"--threshold", "100"}), HasSubstr("0 of 12 details kept"));
}

TEST_F(Reverse, WritesCoarsePolygonAndPicture) {
    ASSERT_EQ(run({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--repeat", "--coarse", "c.csv", "--picture",
                   "p.svg"})
                  .code,
              0);
    EXPECT_EQ(numbers(here.read("c.csv")).size(), 16U);
    EXPECT_THAT(here.read("p.svg"), AllOf(HasSubstr("level 0: 8 points"), Not(HasSubstr("c.csv"))));
    ASSERT_EQ(run({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--repeat", "-o", "p.json"}).code, 0);
    EXPECT_EQ(here.run({"compose", "p.json", "--level", "0"}).out, here.read("c.csv"));
    ASSERT_EQ(here.run({"compose", "p.json", "--level", "1", "-o", "one.json"}).code, 0);
    EXPECT_EQ(here.run({"subdivide", "@fibonacci", "one.json", "-n", "1"}).code, 0);
}

TEST_F(Reverse, ClampsOpenEndsOrWarnsOfThem) {
    const std::vector<std::string> open{
        "data/curves/signal.csv", "-d", "5", "-n", "4", "--word", "LS", "--repeat", "--resample"};
    const Outcome tamed = run(open);
    EXPECT_EQ(tamed.code, 0);
    EXPECT_THAT(tamed.out, HasSubstr("the ends of the curve clamped"));
    EXPECT_EQ(tamed.err, "");
    std::vector<std::string> as_they_are = open;
    as_they_are.push_back("--unclamped");
    const Outcome loose = run(as_they_are);
    EXPECT_EQ(loose.code, 0);
    EXPECT_THAT(loose.err, HasSubstr("G = "));
    const Outcome clamped =
        run({"data/curves/signal.csv", "-d", "5", "-n", "2", "--clamped", "--word", "LS", "--repeat", "--resample"});
    EXPECT_EQ(clamped.code, 0) << clamped.err;
    EXPECT_EQ(clamped.err, "");
}

TEST_F(Reverse, GoesTwentyLevelsDownTheCoastBySlowGrowth) {
    const Outcome outcome = here.run({"reverse", "@slow-growth-4", "data/curves/iceland-coast.csv", "-d", "3", "-n",
                                      "20", "--closed", "--word", "A1A2A3A4", "--repeat", "--cut", "-o", "p.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cut off"));
    const Outcome composed = here.run({"compose", "p.json"});
    std::vector<double> coast = numbers(here.read("data/curves/iceland-coast.csv"));
    coast.resize(numbers(composed.out).size());
    EXPECT_LT(largest_difference(numbers(composed.out), coast), 1e-9);
}

TEST_F(Reverse, RefusesWithTheNumbers) {
    const auto refused = [this](const std::vector<std::string>& arguments, int code, const std::string& text) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, code) << testing::PrintToString(arguments) << outcome.out;
        EXPECT_THAT(outcome.err, HasSubstr(text));
        EXPECT_EQ(outcome.out, "");
    };
    refused({leaf, "-d", "3", "-n", "2", "--closed"}, 3, "no word for the coarse polygon");
    refused({leaf, "-n", "2", "--closed", "--word", "L", "--repeat"}, 2, "no degree");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LX", "--repeat"}, 3, "X");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "L"}, 3, "3 below");
    refused({leaf, "-d", "3", "-n", "9", "--closed", "--word", "LSLSLSLSLS", "--cut"}, 3, "above");
    refused({leaf, "-d", "3", "-n", "60", "--closed", "--word", "L", "--resample"}, 3, "more than 100000000");
    refused({leaf, "-d", "3", "-n", "1000000", "--closed", "--word", "L", "--resample"}, 2, "100000 levels");
    refused({leaf, "-d", "3", "-n", "2", "--word", "(LS)", "--clamped"}, 3, "circular");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--keep", "1", "--threshold", "1"}, 2, "--");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--cut", "--resample"}, 2, "--");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--window", "0"}, 2, "--window");
    refused({leaf, "-d", "3", "-n", "2", "--closed", "--word", "LS", "--picture", "x.png"}, 2, "png");
    here.file("large.csv", "1e200\n2\n3\n");
    refused({"large.csv", "-d", "2", "-n", "1", "--closed", "--word", "LS"}, 3, "1e150");
}

TEST_F(Reverse, ComposeRefusesWhatIsNoPyramid) {
    here.file("bad.json", "{\"format\": \"internode-curve\"}");
    EXPECT_THAT(here.run({"compose", "bad.json"}).err, HasSubstr("bad.json:1:12"));
    EXPECT_EQ(here.run({"compose", "bad.json"}).code, 3);
    EXPECT_EQ(here.run({"compose", "missing.json"}).code, 4);
    EXPECT_EQ(here.run({"compose", "data/pyramids/leaf.json", "--level", "3"}).code, 2);
    EXPECT_EQ(here.run({"compose", "data/pyramids/leaf.json", "--max-points", "19"}).code, 3);
    EXPECT_EQ(here.run({"compose", "data/pyramids/leaf.json", "--max-points", "20"}).code, 0);
}

} // namespace
} // namespace internode::tests
