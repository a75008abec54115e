// SPDX-License-Identifier: MIT
//
// The matrix of one step over a whole word, N' x N, by three routes: stencils gather, masks scatter, Boehm inserts.
//
// Open words keep the new points whose support meets the domain: those from d letters before σ(domain) on. A closed
// word is unrolled for Boehm and folded afterwards.

#pragma once

#include "internode/spline/mask.h"
#include "internode/stencil/automaton.h"
#include "tests/reference/boehm.h"

#include <cstddef>
#include <vector>

namespace internode::reference {

using Matrix = std::vector<std::vector<Number>>;

inline Matrix zero_matrix(std::size_t rows, std::size_t columns) {
    return Matrix(rows, std::vector<Number>(columns));
}

inline Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result = zero_matrix(a.size(), b.front().size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            if (a[i][k].sign() != 0)
                for (std::size_t j = 0; j < b[k].size(); ++j) result[i][j] += a[i][k] * b[k][j];
    return result;
}

/// What a step keeps: the new word, and the places of the new points among the letters of σ(word).
struct Step {
    std::size_t points = 0;     ///< N
    std::size_t first = 0;      ///< letter of σ(word) where new point 0 starts
    std::size_t new_points = 0; ///< N'
    Word word;                  ///< after the step
};

inline Step step_of(const IntervalSystem& system, const Word& word, int degree, Ends ends) {
    const auto d = static_cast<std::size_t>(degree);
    const Word image = system.rules()(word);
    if (ends == Ends::Circular) return {word.size(), 0, image.size(), image};
    const std::size_t left = system.rules()({word.begin(), word.begin() + degree}).size();
    const std::size_t right = system.rules()({word.end() - degree, word.end()}).size();
    const std::size_t letters = image.size() - left - right + 2 * d;
    const auto begin = image.begin() + static_cast<std::ptrdiff_t>(left - d);
    return {word.size() - d, left - d, letters - d, Word(begin, begin + static_cast<std::ptrdiff_t>(letters))};
}

inline Matrix gather_matrix(const IntervalSystem& system, const Word& word, int degree, Ends ends) {
    const std::vector<CellState> states = cell_states(word, degree, ends);
    const StencilAutomaton automaton = make_automaton(system, degree, states, 100'000);
    const auto n = static_cast<std::ptrdiff_t>(states.size());
    Matrix matrix;
    for (std::ptrdiff_t cell = 0; cell < n; ++cell) {
        const std::uint32_t state = automaton.find(states[static_cast<std::size_t>(cell)]);
        for (const StencilAutomaton::Child& child : automaton.children(state)) {
            std::vector<Number> row(states.size());
            std::ptrdiff_t parent = cell + automaton.offset(state);
            for (const Number& weight : automaton.exact_weights(child.row)) {
                if (ends == Ends::Circular)
                    row[static_cast<std::size_t>((parent % n + n) % n)] += weight;
                else
                    row.at(static_cast<std::size_t>(parent)) += weight;
                ++parent;
            }
            matrix.push_back(std::move(row));
        }
    }
    return matrix;
}

inline Matrix scatter_matrix(const IntervalSystem& system, const Word& word, int degree, Ends ends) {
    const auto d = static_cast<std::size_t>(degree);
    const Step step = step_of(system, word, degree, ends);
    Matrix matrix = zero_matrix(step.new_points, step.points);
    std::size_t start = 0;
    for (std::size_t k = 0; k < step.points; ++k) {
        Word support;
        for (std::size_t i = k; i <= k + d; ++i) support.push_back(word[i % word.size()]);
        const Mask scattered = mask(system, support);
        for (std::size_t e = 0; e < scattered.entries.size(); ++e) {
            const std::size_t place = start + e;
            if (ends == Ends::Circular)
                matrix[place % step.new_points][k] += scattered.entries[e].weight;
            else if (place >= step.first && place - step.first < step.new_points)
                matrix[place - step.first][k] += scattered.entries[e].weight;
        }
        start += system.rules().image(word[k]).size();
    }
    return matrix;
}

/// Knots of a word, then of its refinement on the same line, with d intervals of length 1 added at both ends.
struct PaddedKnots {
    std::vector<Number> coarse;
    std::vector<Number> fine;
};

inline PaddedKnots padded_knots(const IntervalSystem& system, const Word& word, std::size_t d) {
    PaddedKnots result;
    for (std::size_t i = 0; i < d; ++i) result.coarse.emplace_back(static_cast<long>(i) - static_cast<long>(d));
    result.fine = result.coarse;
    Number coarse(0);
    Number fine(0);
    for (const Symbol letter : word) {
        result.coarse.push_back(coarse);
        coarse += system.length(letter);
        for (const Symbol part : system.rules().image(letter)) {
            result.fine.push_back(fine);
            fine += system.length(part) / system.ratio();
        }
    }
    if (fine != coarse) throw std::logic_error("a refined word has another length");
    for (std::size_t i = 0; i <= d; ++i) {
        const Number beyond = coarse + Number(static_cast<long>(i));
        result.coarse.push_back(beyond);
        result.fine.push_back(beyond);
    }
    return result;
}

/// Rows of the |σ(word)| - d points of the refinement over the |word| - d points of the word; word of more than d
/// letters, no d+1 of them empty in a row.
inline Matrix boehm_rows(const IntervalSystem& system, const Word& word, std::size_t d) {
    const PaddedKnots knots = padded_knots(system, word, d);
    const std::size_t columns = word.size() - d;
    Spline<Number> spline{d, knots.coarse, {}};
    for (std::size_t i = 0; i < word.size() + d; ++i) {
        spline.points.emplace_back(columns);
        if (i >= d && i - d < columns) spline.points.back()[i - d] = Number(1);
    }
    insert_missing(spline, knots.fine);
    return {spline.points.begin() + static_cast<std::ptrdiff_t>(d),
            spline.points.end() - static_cast<std::ptrdiff_t>(d)};
}

inline Matrix boehm_matrix(const IntervalSystem& system, const Word& word, int degree, Ends ends) {
    const auto d = static_cast<std::size_t>(degree);
    const Step step = step_of(system, word, degree, ends);
    if (ends == Ends::Open) {
        const Matrix rows = boehm_rows(system, word, d);
        const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(step.first);
        return {begin, begin + static_cast<std::ptrdiff_t>(step.new_points)};
    }
    // Whole periods: d letters or more on both sides of the one in the middle.
    const std::size_t side = d / word.size() + 1;
    Word unrolled;
    for (std::size_t copy = 0; copy < 2 * side + 1; ++copy) unrolled.insert(unrolled.end(), word.begin(), word.end());
    const Matrix rows = boehm_rows(system, unrolled, d);
    Matrix folded = zero_matrix(step.new_points, step.points);
    for (std::size_t l = 0; l < step.new_points; ++l) {
        const std::vector<Number>& row = rows[side * step.new_points + l];
        for (std::size_t k = 0; k < row.size(); ++k) folded[l][k % step.points] += row[k];
    }
    return folded;
}

} // namespace internode::reference
