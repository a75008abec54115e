// SPDX-License-Identifier: MIT
//
// An open curve's matrix: the longest run of rows that repeat m rows further down and one column further right, for
// some m, is the pattern. The rows before and after it are what they are.

#include "internode/point/infer/floor_division.h"
#include "internode/point/infer/inference.h"
#include "internode/point/infer/row_pattern.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// Whether b is a, moved `by` columns to the right.
bool is_moved(const RationalRow& a, const RationalRow& b, std::ptrdiff_t by) {
    return std::ranges::equal(a, b, [by](const RationalEntry& x, const RationalEntry& y) {
        return static_cast<std::ptrdiff_t>(x.column) + by == static_cast<std::ptrdiff_t>(y.column) &&
               x.value == y.value;
    });
}

/// Rows begin … begin + count - 1 repeat `arity` rows further down.
struct Run {
    std::size_t arity = 0;
    std::size_t begin = 0;
    std::size_t count = 0;
    [[nodiscard]] std::size_t end() const { return begin + count + arity; } ///< one past the last row of the pattern
};

Run longest_run(const RationalMatrix& matrix, std::size_t arity) {
    Run longest{arity, 0, 0};
    Run run = longest;
    for (std::size_t row = 0; row + arity < matrix.rows.size(); ++row) {
        const bool repeats = is_moved(matrix.rows[row], matrix.rows[row + arity], 1);
        if (repeats && run.count++ == 0) run.begin = row;
        if (!repeats) run.count = 0;
        if (run.count > longest.count) longest = run;
    }
    return longest;
}

Run best_run(const RationalMatrix& matrix) {
    Run best;
    const std::size_t most = std::min(max_inferred_arity, matrix.rows.size() / 2);
    for (std::size_t arity = 1; arity <= most; ++arity) {
        const Run run = longest_run(matrix, arity);
        if (run.count > best.count) best = run;
    }
    return best;
}

/// The stencils of the run, about old point q for new point m q + r.
std::vector<PointStencil> stencils_of(const RationalMatrix& matrix, const Run& run) {
    assert(run.arity > 0 && run.end() <= matrix.rows.size());
    std::vector<PointStencil> stencils(run.arity);
    for (std::size_t row = run.begin; row < run.begin + run.arity; ++row)
        for (const RationalEntry& entry : matrix.rows[row])
            stencils[row % run.arity].push_back(
                {static_cast<std::ptrdiff_t>(entry.column) - static_cast<std::ptrdiff_t>(row / run.arity),
                 entry.value});
    return stencils;
}

/// Whether a row is the one of the run, as far as that, moved.
bool follows(const RationalMatrix& matrix, const Run& run, std::size_t row) {
    const auto from_begin = static_cast<std::ptrdiff_t>(row) - static_cast<std::ptrdiff_t>(run.begin);
    const Division place = floor_division(from_begin, static_cast<std::ptrdiff_t>(run.arity));
    const RationalRow& like = matrix.rows[run.begin + static_cast<std::size_t>(place.remainder)];
    return is_moved(like, matrix.rows[row], place.quotient);
}

/// The row of the run's first period that this one should follow.
std::size_t like(const Run& run, std::size_t row) {
    const auto from_begin = static_cast<std::ptrdiff_t>(row) - static_cast<std::ptrdiff_t>(run.begin);
    const Division place = floor_division(from_begin, static_cast<std::ptrdiff_t>(run.arity));
    return run.begin + static_cast<std::size_t>(place.remainder);
}

/// Rows that break the pattern while two periods beyond them follow it again: one may do so by chance.
std::vector<IrregularRow> irregular_rows(const RationalMatrix& matrix, const Run& run) {
    std::size_t first = run.begin;
    std::size_t end = run.end();
    std::size_t in_a_row = 0;
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        in_a_row = follows(matrix, run, row) ? in_a_row + 1 : 0;
        if (in_a_row < 2 * run.arity) continue;
        first = std::min(first, row + 1 - 2 * run.arity);
        end = std::max(end, row + 1);
    }
    std::vector<IrregularRow> rows;
    for (std::size_t row = first; row < end; ++row)
        if (!follows(matrix, run, row)) rows.push_back({row, like(run, row)});
    return rows;
}

InferenceProblem too_small(const RationalMatrix& matrix) {
    return {"too small to tell the pattern: among the " + std::to_string(matrix.rows.size()) +
                " rows no two periods follow each other, the second one column to the right of the first",
            "write the matrix out for more points",
            {}};
}

InferenceProblem irregularity(std::vector<IrregularRow> rows) {
    assert(!rows.empty());
    const std::string first = std::to_string(rows.front().row + 1);
    return {std::to_string(rows.size()) + (rows.size() == 1 ? " row breaks" : " rows break") +
                " a pattern that holds before and after, row " + first + (rows.size() == 1 ? "" : " first"),
            {},
            std::move(rows)};
}

/// The rows of the matrix that old point i takes.
struct Block {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool regular = false;
};

Block block_of(const OpenPattern& pattern, std::size_t point, std::ptrdiff_t shift) {
    assert(point < pattern.pattern.columns);
    const auto arity = static_cast<std::ptrdiff_t>(pattern.pattern.arity());
    const auto rows = static_cast<std::ptrdiff_t>(pattern.pattern.rows);
    const std::ptrdiff_t begin = arity * static_cast<std::ptrdiff_t>(point) + shift;
    const auto within = [rows](std::ptrdiff_t row) { return std::clamp<std::ptrdiff_t>(row, 0, rows); };
    const std::ptrdiff_t first = point == 0 ? 0 : within(begin);
    const std::ptrdiff_t end = point + 1 == pattern.pattern.columns ? rows : within(begin + arity);
    const bool whole = first == begin && end == begin + arity;
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(end),
            whole && first >= static_cast<std::ptrdiff_t>(pattern.first_regular) &&
                end <= static_cast<std::ptrdiff_t>(pattern.end_regular)};
}

/// The production of an old point near an end; its contexts reach as far as the end and as its stencils need.
PointProduction end_production(const OpenPattern& pattern, std::size_t point, const Block& block, bool at_begin) {
    assert(block.begin <= block.end && block.end <= pattern.matrix.rows.size());
    std::vector<PointStencil> successor;
    for (std::size_t row = block.begin; row < block.end; ++row) {
        PointStencil& stencil = successor.emplace_back();
        for (const RationalEntry& entry : pattern.matrix.rows[row])
            stencil.push_back(
                {static_cast<std::ptrdiff_t>(entry.column) - static_cast<std::ptrdiff_t>(point), entry.value});
    }
    PointProduction production = with_shortest_contexts(1, std::move(successor));
    (at_begin ? production.left : production.right) = at_begin ? point : pattern.pattern.columns - 1 - point;
    (at_begin ? production.after_marker : production.before_marker) = true;
    return production;
}

InferenceProblem end_problem(const PointProduction& production, bool at_begin) {
    const std::size_t reach = at_begin ? production.right : production.left;
    return {std::string("a point near the ") + (at_begin ? "first" : "last") + " one depends on a point " +
                std::to_string(reach) + " places away, near the other end",
            "the matrix of a closed curve is read without --open; else write it out for more points",
            {}};
}

} // namespace

InferredOpenPattern infer_open(const RationalMatrix& matrix) {
    const Run run = best_run(matrix);
    if (run.count < std::max<std::size_t>(run.arity, 1)) return {{}, too_small(matrix)};
    std::vector<IrregularRow> irregular = irregular_rows(matrix, run);
    if (!irregular.empty()) return {{}, irregularity(std::move(irregular))};
    OpenPattern pattern;
    pattern.pattern = {matrix.rows.size(), matrix.columns, stencils_of(matrix, run), rows_not_affine(matrix)};
    pattern.first_regular = run.begin;
    pattern.end_regular = run.end();
    pattern.matrix = matrix;
    if (auto problem = size_problem(pattern.pattern)) return {{}, std::move(problem)};
    return {std::move(pattern), {}};
}

InferredOpenProductions open_productions(const OpenPattern& pattern, std::ptrdiff_t shift) {
    const std::size_t columns = pattern.pattern.columns;
    std::size_t first = 0;
    while (first < columns && !block_of(pattern, first, shift).regular) ++first;
    std::size_t last = 0;
    while (last < columns && !block_of(pattern, columns - 1 - last, shift).regular) ++last;
    if (first == columns)
        return {{}, InferenceProblem{"too small for this shift: no old point has a whole period of rows", {}, {}}};
    OpenProductions result{production_of(pattern.pattern, shift), {}, {}, first + last};
    for (std::size_t i = 0; i < first; ++i) {
        result.first.push_back(end_production(pattern, i, block_of(pattern, i, shift), true));
        const std::size_t needed = i + 1 + result.first.back().right;
        if (needed + last > columns) return {{}, end_problem(result.first.back(), true)};
        result.least_points = std::max(result.least_points, needed);
    }
    for (std::size_t i = 0; i < last; ++i) {
        const std::size_t point = columns - 1 - i;
        result.last.push_back(end_production(pattern, point, block_of(pattern, point, shift), false));
        const std::size_t needed = i + 1 + result.last.back().left;
        if (needed + first > columns) return {{}, end_problem(result.last.back(), false)};
        result.least_points = std::max(result.least_points, needed);
    }
    result.least_points = std::max<std::size_t>(result.least_points, 1);
    return {std::move(result), {}};
}

PointGrammar open_grammar(std::string name, const OpenProductions& productions, OpenForm form) {
    PointProduction inner = productions.inner.production;
    std::vector<PointProduction> rules;
    for (const PointProduction& end : productions.first)
        if (form == OpenForm::Long || !is_identity(end) || end.left >= inner.left) rules.push_back(end);
    if (form == OpenForm::Long) {
        inner.left = std::max(inner.left, productions.first.size());
        inner.right = std::max(inner.right, productions.last.size());
        rules.push_back(inner);
    }
    // From the last but one outward in the long form, as S0 numbers them.
    for (auto end = productions.last.rbegin(); end != productions.last.rend(); ++end)
        if (form == OpenForm::Long || !is_identity(*end) || end->right >= inner.right) rules.push_back(*end);
    if (form == OpenForm::Ordered) rules.push_back(inner);
    return to_grammar(std::move(name), form == OpenForm::Long ? WordEnds::KeptMarkers : WordEnds::Markers, rules);
}

} // namespace internode
