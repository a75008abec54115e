// SPDX-License-Identifier: MIT

#include "internode/spline/window.h"

#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/marsden.h"
#include "tests/reference/step_matrix.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

namespace internode {
namespace {

using reference::polar_power;
using testing::ElementsAre;
using tests::system_of;
using tests::word_of;

std::vector<Word> persistent_windows(const IntervalSystem& system, std::size_t d) {
    return persistent_words(system.rules(), 2 * d - 1, 100'000);
}

/// A row against what it must be: convex, and right for every polynomial of degree <= d over the old knots, whose new
/// knots are `arguments` (Greville abscissae are degree 1).
void expect_row(const std::vector<Number>& row, const std::vector<Number>& local, std::span<const Number> arguments) {
    const std::size_t d = row.size() - 1;
    for (const Number& weight : row) EXPECT_GE(weight.sign(), 0);
    for (std::size_t m = 0; m <= d; ++m) {
        Number sum;
        for (std::size_t i = 0; i <= d; ++i) sum += row[i] * polar_power<Number>(std::span(local).subspan(i, d), m);
        EXPECT_EQ(sum, polar_power<Number>(arguments, m)) << "power " << m;
    }
}

/// Every row of a window; windows with empty intervals: leading rows only as far as the letters before are empty, or
/// none are (an open end).
void expect_window(const IntervalSystem& system, const Word& window) {
    const WindowStencils stencils = window_stencils(system, window);
    const std::size_t d = window.size() / 2 + 1;
    const Word image = system.rules()(window);
    const std::size_t first =
        system.rules()({window.begin(), window.begin() + static_cast<std::ptrdiff_t>(d - 1)}).size();
    std::vector<Number> local = knots(system, window);
    const std::vector<Number> fine = knots(system, image);
    for (Number& knot : local) knot *= system.ratio();
    ASSERT_EQ(stencils.children.size(), system.rules().image(window[d - 1]).size());
    for (std::size_t c = 0; c < stencils.children.size(); ++c) {
        expect_row(stencils.children[c], local, std::span(fine).subspan(first + c + 1, d));
        const auto begin = image.begin() + static_cast<std::ptrdiff_t>(first + c + 1 - d);
        EXPECT_EQ(stencils.child_windows[c], Word(begin, begin + static_cast<std::ptrdiff_t>(2 * d - 1)));
    }
    ASSERT_EQ(stencils.leading.size(), d);
    for (std::size_t z = 1; z <= d; ++z)
        expect_row(stencils.leading[z - 1], local, std::span(fine).subspan(first + 1 - z, d));
}

TEST(Window, FibonacciStencilIsAsPrinted) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Number phi = fibonacci.ratio();
    for (const char* window : {"LLS", "SLS"}) {
        const WindowStencils stencils = window_stencils(fibonacci, word_of(fibonacci, window));
        ASSERT_EQ(stencils.children.size(), 2U);
        EXPECT_THAT(stencils.children[0],
                    ElementsAre(Number(0), Number(4) - Number(2) * phi, Number(2) * phi - Number(3)));
        EXPECT_THAT(stencils.children[1], ElementsAre(Number(0), Number(0), Number(1)));
    }
}

TEST(Window, FibonacciHasAFewPersistentWindowsAndRows) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const std::vector<std::size_t> rows{3, 7, 9, 13, 17, 19, 23, 25};
    for (std::size_t d = 1; d <= 8; ++d) {
        const std::vector<Word> all = persistent_windows(fibonacci, d);
        EXPECT_EQ(all.size(), 2 * d);
        std::size_t children = 0;
        for (const Word& window : all) children += window_stencils(fibonacci, window).children.size();
        EXPECT_EQ(children, rows[d - 1]) << "degree " << d;
    }
}

TEST(Window, UniformCubicHasTheMasksOfCatmullAndClark) {
    const IntervalSystem uniform = system_of("A->AA");
    const WindowStencils stencils = window_stencils(uniform, word_of(uniform, "AAAAA"));
    ASSERT_EQ(stencils.children.size(), 2U);
    EXPECT_THAT(stencils.children[0], ElementsAre(Number(0), Rational(1, 8), Rational(3, 4), Rational(1, 8)));
    EXPECT_THAT(stencils.children[1], ElementsAre(Number(0), Number(0), Rational(1, 2), Rational(1, 2)));
}

TEST(Window, RowsReproducePolynomialsForEveryBundledGrammar) {
    const std::size_t largest_degree = tests::in_full() ? 6 : 4;
    for (const auto& [name, system] : tests::bundled_systems()) {
        SCOPED_TRACE(name);
        for (std::size_t d = 1; d <= largest_degree; ++d) {
            const std::vector<Word> all = persistent_windows(system, d);
            const std::size_t stride = all.size() / 12 + 1;
            for (std::size_t i = 0; i < all.size(); i += stride) expect_window(system, all[i]);
        }
    }
}

TEST(Window, RowsReproducePolynomialsBetweenEmptyIntervals) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 1; d <= 3; ++d)
        for (const Word& window : tests::words_with_zeros(2, 2 * d - 1))
            if (window[d - 1] != zero_interval) expect_window(fibonacci, window);
}

TEST(Window, TheLastLeadingRowOverZerosKeepsThePoint) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 1; d <= 6; ++d) {
        Word window(d - 1, zero_interval);
        for (const Symbol letter : word_of(fibonacci, "LSLLSL")) window.push_back(letter);
        window.resize(2 * d - 1, to_symbol(0));
        std::vector<Number> kept(d + 1);
        kept[0] = Number(1);
        EXPECT_EQ(window_stencils(fibonacci, window).leading.back(), kept);
    }
}

TEST(Window, BezierRowsAreTheBlossomAtTheEndsOfTheInterval) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 1; d <= 6; ++d) {
        for (const Word& window : persistent_windows(fibonacci, d)) {
            const std::vector<std::vector<Number>> rows = bezier_rows(fibonacci, window);
            const std::vector<Number> local = knots(fibonacci, window);
            ASSERT_EQ(rows.size(), d + 1);
            for (std::size_t b = 0; b <= d; ++b) {
                std::vector<Number> arguments(d - b, local[d - 1]);
                arguments.resize(d, local[d]);
                expect_row(rows[b], local, arguments);
            }
            EXPECT_EQ(rows[0][d], Number(0)) << "d points reach a knot from the right";
            EXPECT_EQ(rows[d][0], Number(0)) << "and from the left";
        }
    }
}

/// De Casteljau at τ, barycentric in [from, to]: the Bézier rows of [from, τ] or, from the right, of [τ, to].
std::vector<Number> bezier_point(std::vector<std::vector<Number>> rows, const std::vector<Number>& ratios) {
    for (const Number& ratio : ratios) {
        for (std::size_t i = 0; i + 1 < rows.size(); ++i)
            for (std::size_t c = 0; c < rows[i].size(); ++c)
                rows[i][c] = (Number(1) - ratio) * rows[i][c] + ratio * rows[i + 1][c];
        rows.pop_back();
    }
    return rows.front();
}

TEST(Window, ChildrensBezierPointsAreDeCasteljausOfTheirParent) {
    // Rows of the child's Bézier points over the new points, times the new points over the old ones, against the
    // blossom of the parent's Bézier curve.
    for (const auto& text : {"L->SL, S->L", "A->AB, B->BBB", "A->BB, B->A"}) {
        const IntervalSystem system = system_of(text);
        for (int degree = 1; degree <= 4; ++degree) {
            const auto d = static_cast<std::size_t>(degree);
            // One period, so long that no row wraps.
            Word word{to_symbol(0)};
            while (word.size() < 4 * d + 2) word = system.rules()(word);
            const Word image = system.rules()(word);
            const reference::Matrix step = reference::gather_matrix(system, word, degree, Ends::Circular);
            std::size_t child = 0;
            for (std::size_t j = 0; j < word.size(); ++j) {
                const WordView letters = system.rules().image(word[j]);
                if (j < 2 * d || j + 2 * d > word.size()) {
                    child += letters.size();
                    continue;
                }
                const auto old = word.begin() + static_cast<std::ptrdiff_t>(j + 1 - d);
                const auto parent = bezier_rows(system, Word(old, old + degree * 2 - 1));
                Number position;
                const Number total = knots(system, letters).back();
                for (const Symbol letter : letters) {
                    const auto fresh = image.begin() + static_cast<std::ptrdiff_t>(child + 1 - d);
                    const auto rows = bezier_rows(system, Word(fresh, fresh + degree * 2 - 1));
                    const Number end = position + system.length(letter);
                    for (std::size_t b = 0; b <= d; ++b) {
                        std::vector<Number> ratios(d - b, position / total);
                        ratios.resize(d, end / total);
                        const std::vector<Number> expected = bezier_point(parent, ratios);
                        for (std::size_t k = 0; k <= d; ++k) {
                            Number sum;
                            for (std::size_t l = 0; l <= d; ++l) sum += rows[b][l] * step[child + l - d][j + k - d];
                            EXPECT_EQ(sum, expected[k]);
                        }
                    }
                    position = end;
                    ++child;
                }
            }
        }
    }
}

TEST(Window, RefusesWhatIsNotAWindow) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_THROW((void)window_stencils(fibonacci, Word{}), std::invalid_argument);
    EXPECT_THROW((void)window_stencils(fibonacci, word_of(fibonacci, "LS")), std::invalid_argument);
    EXPECT_THAT([&] { (void)window_stencils(fibonacci, word_of(fibonacci, "L0L")); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("middle interval of a window")));
    EXPECT_THROW((void)bezier_rows(fibonacci, word_of(fibonacci, "0")), std::invalid_argument);
    const WindowPiece piece(fibonacci, word_of(fibonacci, "LLS"));
    EXPECT_THROW((void)piece.child(2), std::out_of_range);
    EXPECT_THROW((void)piece.child_window(2), std::out_of_range);
    EXPECT_THROW((void)piece.leading(3), std::out_of_range);
    EXPECT_THROW((void)piece.bezier(3), std::out_of_range);
}

/// The r-th derivative of x^m.
Number derivative_of_power(const Number& x, int m, int r) {
    if (r > m) return Number(0);
    Number value = pow(x, m - r);
    for (int factor = m; factor > m - r; --factor) value *= Number(factor);
    return value;
}

/// Derivative rows against polynomials: over the control points of x^m they give its derivatives at the knot.
void expect_derivatives(const IntervalSystem& system, const Word& window) {
    const std::size_t d = window.size() / 2 + 1;
    const int beyond = static_cast<int>(d) + 2;
    std::vector<Number> local = knots(system, window);
    for (Number& knot : local) knot += Number(1); // 0^0 aside
    for (const PieceEnd end : {PieceEnd::Begin, PieceEnd::End}) {
        const Number& knot = local[end == PieceEnd::Begin ? d - 1 : d];
        const std::vector<std::vector<Number>> rows = derivative_rows(system, window, end, beyond);
        ASSERT_EQ(rows.size(), d + 3);
        for (int r = 0; r <= beyond; ++r) {
            const std::vector<Number>& row = rows[static_cast<std::size_t>(r)];
            ASSERT_EQ(row.size(), d + 1);
            for (std::size_t m = 0; m <= d; ++m) {
                Number sum;
                for (std::size_t i = 0; i <= d; ++i)
                    sum += row[i] * polar_power<Number>(std::span(local).subspan(i, d), m);
                EXPECT_EQ(sum, derivative_of_power(knot, static_cast<int>(m), r)) << "x^" << m << ", order " << r;
            }
        }
    }
}

TEST(DerivativeRows, DifferentiatePolynomialsForEveryBundledGrammar) {
    for (const auto& [name, system] : tests::bundled_systems()) {
        SCOPED_TRACE(name);
        for (std::size_t d = 1; d <= 4; ++d) {
            const std::vector<Word> all = persistent_windows(system, d);
            const std::size_t stride = all.size() / 6 + 1;
            for (std::size_t i = 0; i < all.size(); i += stride) expect_derivatives(system, all[i]);
        }
    }
}

TEST(DerivativeRows, DifferentiatePolynomialsBetweenEmptyIntervals) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 1; d <= 3; ++d)
        for (const Word& window : tests::words_with_zeros(2, 2 * d - 1))
            if (window[d - 1] != zero_interval) expect_derivatives(fibonacci, window);
}

TEST(DerivativeRows, NeedNoPointBeyondASimpleKnot) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 2; d <= 6; ++d)
        for (const Word& window : persistent_windows(fibonacci, d)) {
            const auto begin = derivative_rows(fibonacci, window, PieceEnd::Begin, static_cast<int>(d));
            const auto end = derivative_rows(fibonacci, window, PieceEnd::End, static_cast<int>(d));
            for (std::size_t m = 0; m < d; ++m) {
                EXPECT_EQ(begin[m].back(), Number(0)) << "the curve is smooth there: v_j is not needed";
                EXPECT_EQ(end[m].front(), Number(0));
            }
            EXPECT_NE(begin[d].back(), Number(0));
        }
}

TEST(DerivativeRows, RefuseANegativeOrder) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_THROW((void)derivative_rows(fibonacci, word_of(fibonacci, "L"), PieceEnd::Begin, -1), std::invalid_argument);
}

} // namespace
} // namespace internode
