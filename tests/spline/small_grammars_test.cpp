// SPDX-License-Identifier: MIT
//
// Promise P8: exact means exact. Blossoms against knot insertion for every grammar of at most three symbols and rules
// of at most three letters, up to names and mirror.

#include "internode/spline/mask.h"
#include "internode/spline/window.h"
#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/nearest.h"
#include "tests/reference/step_matrix.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <map>

namespace internode {
namespace {

const std::size_t grammar_stride = tests::stride();
constexpr std::size_t every_word = std::numeric_limits<std::size_t>::max();

/// `count` of the words at most, evenly spread; which ones depends on `shift`.
std::vector<Word> sample(const std::vector<Word>& words, std::size_t count, std::size_t shift) {
    if (words.size() <= count) return words;
    std::vector<Word> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(words[(shift + i * words.size() / count) % words.size()]);
    return chosen;
}

/// Calls visit(system, i) for the valid ones of the grammars, i their number.
template<typename Visit>
void for_valid_grammars(Visit visit) {
    const std::vector<IntervalGrammar> grammars = tests::small_grammars(3, 3);
    std::size_t valid = 0;
    for (std::size_t i = 0; i < grammars.size() && !testing::Test::HasFailure(); i += grammar_stride) {
        const Verdict verdict = validate(grammars[i]);
        if (!verdict.system) continue;
        ++valid;
        SCOPED_TRACE(i);
        visit(*verdict.system, i);
    }
    testing::Test::RecordProperty("grammars", static_cast<int>(grammars.size()));
    testing::Test::RecordProperty("valid", static_cast<int>(valid));
    EXPECT_GT(valid, grammars.size() / grammar_stride / 4);
}

/// The masks of one system by both routes; each weight is rounded to the nearest double, which is asked once a value.
class MaskCheck {
public:
    explicit MaskCheck(const IntervalSystem& system)
        : system_(system) {}

    void expect_by_insertion(const Word& word) {
        const Mask result = mask(system_, word);
        const reference::Matrix inserted = reference::boehm_rows(system_, word, word.size() - 1);
        ASSERT_EQ(result.entries.size(), inserted.size());
        for (std::size_t l = 0; l < inserted.size(); ++l) {
            EXPECT_EQ(result.entries[l].weight, inserted[l][0]);
            expect_nearest(result.entries[l].weight);
        }
    }

private:
    void expect_nearest(const Number& weight) {
        const double rounded = weight.to_double();
        const auto [known, is_new] = seen_.try_emplace(rounded, weight);
        if (is_new || known->second != weight) {
            EXPECT_TRUE(reference::is_nearest(rounded, weight));
        }
    }

    const IntervalSystem& system_;
    std::map<double, Number> seen_;
};

/// The masks of at most `words_each` persistent words of every grammar.
void expect_masks_by_insertion(std::size_t degree, std::size_t words_each) {
    for_valid_grammars([&](const IntervalSystem& system, std::size_t i) {
        MaskCheck check(system);
        for (const Word& word : sample(persistent_words(system.rules(), degree + 1, 100'000), words_each, i))
            check.expect_by_insertion(word);
    });
}

/// The window inside a longer word: rows of the children, and of the points just left of them.
void expect_window_by_insertion(const IntervalSystem& system, const Word& window) {
    const WindowStencils stencils = window_stencils(system, window);
    const std::size_t d = window.size() / 2 + 1;
    Word longer(d, window.front());
    longer.insert(longer.end(), window.begin(), window.end());
    longer.insert(longer.end(), d, window.back());
    const std::size_t j = 2 * d - 1;
    const std::size_t first = system.rules()({longer.begin(), longer.begin() + static_cast<std::ptrdiff_t>(j)}).size();
    const reference::Matrix inserted = reference::boehm_rows(system, longer, d);
    const auto expect_row = [&](const std::vector<Number>& row, std::size_t l) {
        std::vector<Number> whole(inserted[l].size());
        std::copy(row.begin(), row.end(), whole.begin() + static_cast<std::ptrdiff_t>(j - d));
        EXPECT_EQ(inserted[l], whole);
    };
    for (std::size_t c = 0; c < stencils.children.size(); ++c) expect_row(stencils.children[c], first + c);
    for (std::size_t z = 1; z <= d; ++z) expect_row(stencils.leading[z - 1], first - z);
}

TEST(SmallGrammars, AreAsManyAsCounted) {
    EXPECT_EQ(tests::small_grammars(1, 3).size(), 3U);
    std::size_t all = 0;
    for (std::size_t n = 1; n <= 3; ++n) {
        std::size_t grammars = 1;
        for (std::size_t i = 0; i < n; ++i) grammars *= tests::short_words(n, 3).size();
        all += grammars;
    }
    EXPECT_EQ(all, 59'518U);
}

TEST(SmallGrammars, AllMasksOfDegree1And2AgreeWithKnotInsertion) {
    expect_masks_by_insertion(1, every_word);
    expect_masks_by_insertion(2, every_word);
}

TEST(SmallGrammars, AllMasksOfDegree3AgreeWithKnotInsertion) {
    expect_masks_by_insertion(3, every_word);
}

/// Of degree 4 all masks would take minutes, and so would all windows.
TEST(SmallGrammars, MasksAndWindowsAgreeWithKnotInsertion) {
    for_valid_grammars([](const IntervalSystem& system, std::size_t i) {
        MaskCheck check(system);
        for (const Word& word : sample(persistent_words(system.rules(), 5, 100'000), 2, i))
            check.expect_by_insertion(word);
        for (const std::size_t d : {1 + i % 4, 1 + (i + 2) % 4})
            for (const Word& window : sample(persistent_words(system.rules(), 2 * d - 1, 100'000), 1, i))
                expect_window_by_insertion(system, window);
    });
}

} // namespace
} // namespace internode
