// SPDX-License-Identifier: MIT
//
// The short way: a polygon refined by the text of a grammar, in one call.
//
//     const std::vector<std::array<double, 2>> fine = internode::refine(
//         "L -> S L, S -> L", points, {.degree = 3, .ends = Ends::Circular, .word = "LSLLS"}, 3);
//     const std::vector<std::array<double, 2>> cut = internode::refine("@s0/13", points, {}, 3);
//
// Here the grammar, the word and the polygon are the program's own. What is wrong with them is a mistake of the caller:
// an exception, whose text is what the command would say, with line, column and hint. A program that takes them from
// its users goes step by step instead, where each fact is a value: grammar/intervals/parse.h, interval/validity.h,
// curve/curve.h, curve/refinement.h; of a point grammar point/point_system.h, point/interpreter.h (docs/library.md).

#pragma once

#include "internode/curve/curve.h"
#include "internode/stencil/plan.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// A point grammar says itself where its points go and how its ends are: for it the first four have no meaning.
struct RefineOptions {
    int degree = 3; ///< 1 … 12
    Ends ends = Ends::Open;
    /// The knot intervals: the letters are repeated until they fit the points. Empty: the axiom of the grammar, which
    /// is taken as it is, or of a grammar of one symbol that symbol.
    std::string word{};
    /// Whether open ends are those of the polygon: the word then names the N - degree intervals between them, else all
    /// N + degree. Without a meaning for circular ends and for an axiom.
    bool clamped = true;
    std::size_t max_points = 100'000'000; ///< after all steps
    ApplyOptions apply{};
};

/// The curve of a polygon before its first step: `points` are whole rows of `dimension` coordinates. `grammar` is the
/// text of an interval grammar, or the name of a bundled one, "@fibonacci".
/// \throw std::invalid_argument with everything that is wrong with the grammar, the word or the polygon
[[nodiscard]] Curve curve_from(std::string_view grammar, std::span<const double> points, std::size_t dimension,
                               const RefineOptions& options = {});

/// The points after `steps` >= 0 steps, in rows as before; of a point grammar after so many cycles and all its
/// interpretations, in the order of its word: the modules that are one point each.
/// \throw std::invalid_argument as above, for fewer steps and for an interpretation that makes points of another
/// dimension; LimitExceeded for more than max_points or too many states; std::range_error where a rule of a point
/// grammar leaves the numbers
[[nodiscard]] std::vector<double> refine(std::string_view grammar, std::span<const double> points,
                                         std::size_t dimension, const RefineOptions& options, int steps);

/// The same for points that are arrays.
template<std::size_t Dimension>
[[nodiscard]] std::vector<std::array<double, Dimension>>
refine(std::string_view grammar, const std::vector<std::array<double, Dimension>>& points, const RefineOptions& options,
       int steps) {
    std::vector<double> rows;
    rows.reserve(Dimension * points.size());
    for (const auto& point : points) rows.insert(rows.end(), point.begin(), point.end());
    const std::vector<double> fine = refine(grammar, rows, Dimension, options, steps);
    std::vector<std::array<double, Dimension>> result(fine.size() / Dimension);
    for (std::size_t i = 0; i < fine.size(); ++i) result[i / Dimension][i % Dimension] = fine[i];
    return result;
}

} // namespace internode
