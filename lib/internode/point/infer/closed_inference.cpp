// SPDX-License-Identifier: MIT
//
// A ring's matrix, block by block of m rows: each block is the one before it, moved one column to the right.

#include "internode/point/infer/inference.h"
#include "internode/point/infer/row_pattern.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <map>

namespace internode {

namespace {

struct RowLess {
    bool operator()(const RationalRow& a, const RationalRow& b) const {
        const auto less = [](const RationalEntry& x, const RationalEntry& y) {
            return x.column != y.column ? x.column < y.column : x.value < y.value;
        };
        return std::ranges::lexicographical_compare(a, b, less);
    }
};

/// The row as old point 0 of its ring would see it.
RationalRow rotated(const RationalRow& row, std::size_t by, std::size_t columns) {
    assert(by < columns);
    RationalRow result = row;
    for (RationalEntry& entry : result) entry.column = (entry.column + columns - by) % columns;
    std::ranges::sort(result, {}, &RationalEntry::column);
    return result;
}

/// One row of each residue class, as most of its rows have it, and the rows that have it otherwise.
struct Classes {
    std::vector<RationalRow> rows;
    std::vector<IrregularRow> irregular;
};

Classes classes_of(const RationalMatrix& matrix, std::size_t arity) {
    assert(matrix.rows.size() == arity * matrix.columns);
    Classes classes;
    for (std::size_t r = 0; r < arity; ++r) {
        std::map<RationalRow, std::vector<std::size_t>, RowLess> occurrences;
        for (std::size_t q = 0; q < matrix.columns; ++q)
            occurrences[rotated(matrix.rows[arity * q + r], q, matrix.columns)].push_back(arity * q + r);
        const auto usual = std::ranges::max_element(
            occurrences, [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
        for (const auto& [row, places] : occurrences)
            if (&places != &usual->second)
                for (const std::size_t place : places) classes.irregular.push_back({place, usual->second.front()});
        classes.rows.push_back(usual->first);
    }
    std::ranges::sort(classes.irregular, {}, &IrregularRow::row);
    return classes;
}

/// The shortest arc of the ring that holds all columns of a row: from `first` on, `width` columns; not unique when two
/// gaps between columns are the largest, or there is none.
struct Arc {
    std::size_t first = 0;
    std::size_t width = 0;
    bool unique = false;
};

Arc shortest_arc(const RationalRow& row, std::size_t columns) {
    assert(!row.empty() && row.back().column < columns);
    Arc arc{row.front().column, columns, false};
    std::size_t largest = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t next = i + 1 < row.size() ? row[i + 1].column : row.front().column + columns;
        const std::size_t gap = next - row[i].column - 1;
        if (gap < largest || gap == 0) continue;
        arc = {next % columns, columns - gap, gap > largest};
        largest = gap;
    }
    return arc;
}

/// The stencil of a row of class r about old point 0. Its centre is as near as the ring allows to where new point r of
/// m stands among the old ones when new points are spread evenly, `moved` twice m further on.
PointStencil unrolled(const RationalRow& row, const Arc& arc, std::size_t columns, std::ptrdiff_t target,
                      std::ptrdiff_t arity) {
    assert(!row.empty() && arc.unique && arity > 0);
    const auto n = static_cast<std::ptrdiff_t>(columns);
    const auto twice_centre = [&arc](std::ptrdiff_t first) {
        return 2 * first + static_cast<std::ptrdiff_t>(arc.width) - 1;
    };
    auto first = static_cast<std::ptrdiff_t>(arc.first);
    const auto distance = [&](std::ptrdiff_t candidate) { return std::abs(arity * twice_centre(candidate) - target); };
    while (distance(first - n) <= distance(first)) first -= n;
    while (distance(first + n) < distance(first)) first += n;
    PointStencil stencil;
    for (const RationalEntry& entry : row) {
        const std::size_t along = (entry.column + columns - arc.first) % columns;
        stencil.push_back({first + static_cast<std::ptrdiff_t>(along), entry.value});
    }
    std::ranges::sort(stencil, {}, &StencilTerm::offset);
    return stencil;
}

/// Twice m times the place of new point r among the old ones: (r + 1/2) / m - 1/2.
std::ptrdiff_t even_place(std::ptrdiff_t r, std::ptrdiff_t arity) {
    return 2 * r + 1 - arity;
}

std::optional<InferenceProblem> arc_problem(const RationalRow& row, const Arc& arc, std::size_t r,
                                            std::size_t columns) {
    if (arc.unique) return std::nullopt;
    const std::string count = std::to_string(columns) + (columns == 1 ? " column" : " columns");
    const std::string name = "row " + std::to_string(r + 1);
    if (arc.width == columns)
        return InferenceProblem{"too small to tell the pattern: " + name + " has weights in all of its " + count +
                                    ", so that where its stencil begins cannot be seen",
                                "write the matrix out for more points",
                                {}};
    return InferenceProblem{"too small to tell the pattern: the " + std::to_string(row.size()) + " weights of " + name +
                                " may begin at more than one of its " + count,
                            "write the matrix out for more points",
                            {}};
}

std::optional<InferenceProblem> shape_problem(const RationalMatrix& matrix) {
    const std::size_t rows = matrix.rows.size();
    if (rows > 0 && matrix.columns > 0 && rows % matrix.columns == 0) return std::nullopt;
    const std::string shape = std::to_string(rows) + " rows for " + std::to_string(matrix.columns) + " columns";
    const std::string message = "a closed curve has a whole number of new points for each old one, not " + shape;
    return InferenceProblem{
        message, rows < matrix.columns ? "" : "the matrix of an open curve is read with --open", {}};
}

InferenceProblem irregularity(std::vector<IrregularRow> rows, const RationalMatrix& matrix) {
    assert(!rows.empty());
    const std::size_t first = rows.front().row + 1;
    return {std::to_string(rows.size()) + " of " + std::to_string(matrix.rows.size()) +
                (rows.size() == 1 ? " rows breaks" : " rows break") + " the pattern of the others, row " +
                std::to_string(first) + (rows.size() == 1 ? "" : " first"),
            "rows that differ near both ends belong to an open curve: --open", std::move(rows)};
}

} // namespace

InferredPattern infer_closed(const RationalMatrix& matrix) {
    if (auto problem = shape_problem(matrix)) return {{}, std::move(problem)};
    RowPattern pattern{matrix.rows.size(), matrix.columns, {}, rows_not_affine(matrix)};
    const auto arity = static_cast<std::ptrdiff_t>(matrix.rows.size() / matrix.columns);
    Classes classes = classes_of(matrix, static_cast<std::size_t>(arity));
    if (!classes.irregular.empty()) return {{}, irregularity(std::move(classes.irregular), matrix)};
    std::ptrdiff_t moved = 0; // how far the first stencil is from its even place; the others go along
    bool is_first = true;
    for (std::ptrdiff_t r = 0; r < arity; ++r) {
        const RationalRow& row = classes.rows[static_cast<std::size_t>(r)];
        PointStencil& stencil = pattern.stencils.emplace_back();
        if (row.empty()) continue;
        const Arc arc = shortest_arc(row, matrix.columns);
        if (auto problem = arc_problem(row, arc, static_cast<std::size_t>(r), matrix.columns))
            return {{}, std::move(problem)};
        stencil = unrolled(row, arc, matrix.columns, even_place(r, arity) + moved, arity);
        const std::ptrdiff_t twice_centre = 2 * stencil.front().offset + static_cast<std::ptrdiff_t>(arc.width) - 1;
        if (is_first) moved = arity * twice_centre - even_place(r, arity);
        is_first = false;
    }
    if (auto problem = size_problem(pattern)) return {{}, std::move(problem)};
    return {std::move(pattern), {}};
}

} // namespace internode
