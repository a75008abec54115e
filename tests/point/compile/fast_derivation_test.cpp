// SPDX-License-Identifier: MIT

#include "internode/point/compile/fast_derivation.h"

#include "internode/point/start_word.h"
#include "tests/point/systems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace internode {
namespace {

const std::string chaikin = "points\nring\nP(u) < P(v) > P(w) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 w)\n";
/// One rule that is drawn among one: it does not compile, and is the same every time.
const std::string chance = "points\nring\nP(v) -> P(v) P(2 v) : 1\n";
const PointSettings from_polygon{.dimension = 2, .constants = {}, .start = PointStart::Input};
const std::vector<double> square{0, 0, 1, 0, 1, 1, 0, 1};

struct Case {
    PointSystem system;
    ModuleWord word;
    [[nodiscard]] DerivationStart start() const { return {word, {square.size() / 2}}; }
};

Case case_of(const std::string& text) {
    PointSystem system = point_system(text, from_polygon);
    ModuleWord word = input_word(system, square);
    return {std::move(system), std::move(word)};
}

TEST(FastDerivation, IsTheInterpretersWordBothWays) {
    for (const std::string& text : {chaikin, chance}) {
        const Case one = case_of(text);
        for (std::uint64_t cycles = 0; cycles <= 4; ++cycles) {
            const ModuleWord slow = derived(one.system, one.word, cycles);
            const FastDerivation fast = derive_fast(one.system, one.start(), cycles);
            ASSERT_TRUE(fast.word);
            EXPECT_EQ(shown(one.system, *fast.word), shown(one.system, slow)) << text << cycles;
        }
    }
}

TEST(FastDerivation, SaysWhyTheInterpreterRuns) {
    const Case compiled = case_of(chaikin);
    EXPECT_FALSE(derive_fast(compiled.system, compiled.start(), 3).interpreted);
    FastOptions turned;
    turned.derive.phase = 1;
    const FastDerivation in_phase = derive_fast(compiled.system, compiled.start(), 3, turned);
    EXPECT_EQ(in_phase.interpreted.value().reason, "a phase turns the ring");
    EXPECT_EQ(in_phase.word.value().size(), 32U);
    const Case far = case_of(chance);
    EXPECT_EQ(derive_fast(far.system, far.start(), 1).interpreted.value().reason, "is chosen by chance");
    FastOptions asked;
    asked.interpreter_only = true;
    EXPECT_FALSE(derive_fast(far.system, far.start(), 1, asked).interpreted) << "nobody asked the compiler";
}

TEST(FastDerivation, TellsTheSizeOfAWordThatIsTooLarge) {
    const Case one = case_of(chaikin);
    FastOptions options;
    options.derive.max_modules = 4 << 3;
    EXPECT_TRUE(derive_fast(one.system, one.start(), 3, options).word);
    const FastDerivation larger = derive_fast(one.system, one.start(), 4, options);
    EXPECT_FALSE(larger.word);
    EXPECT_EQ(larger.too_large.value().size.points, 4U << 4);
    EXPECT_EQ(larger.too_large.value().dimension, 2U);
}

TEST(FastDerivation, AnOverflowIsTheInterpretersToTell) {
    const PointSystem system = point_system("points\nring\nP(v) -> P(2 v) P(v)\n", from_polygon);
    const ModuleWord word = input_word(system, std::vector<double>{1e308, 1, 2, 3});
    EXPECT_TRUE(derive_fast(system, {word, {2}}, 0).word);
    const FastDerivation result = derive_fast(system, {word, {2}}, 2);
    EXPECT_FALSE(result.word);
    EXPECT_EQ(result.problem.value().message, derive(system, word, 2).problem.value().message);
}

} // namespace
} // namespace internode
