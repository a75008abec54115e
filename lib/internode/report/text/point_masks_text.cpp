// SPDX-License-Identifier: MIT

#include "internode/report/text/point_masks_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <cassert>

namespace internode {

namespace {

constexpr std::size_t most_columns = 16; // columns of a matrix that is shown as one

std::string mask_line(const PointMasks& masks) {
    if (!masks.mask) return "  mask    none: the rules do not do the same to every point\n";
    std::string weights;
    for (const Rational& weight : masks.mask->coefficients) weights += "  " + to_string(weight);
    const std::ptrdiff_t first = masks.mask->first;
    return fmt::format("  mask  {}\n          of new points {} ... {}, each old point becoming {}\n", weights, first,
                       first + static_cast<std::ptrdiff_t>(masks.mask->coefficients.size()) - 1, masks.mask->arity);
}

std::string dense_rows(const RationalMatrix& matrix) {
    TextTable table(std::vector<Align>(matrix.columns + 1, Align::Right), 2, 2);
    for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        std::vector<std::string> cells{std::to_string(i)};
        cells.resize(matrix.columns + 1, ".");
        for (const RationalEntry& entry : matrix.rows[i]) {
            assert(entry.column < matrix.columns);
            cells[entry.column + 1] = to_string(entry.value);
        }
        table.row(std::move(cells));
    }
    return table.text();
}

std::string sparse_rows(const RationalMatrix& matrix) {
    std::string text;
    for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        text += fmt::format("  {} ", i);
        for (const RationalEntry& entry : matrix.rows[i])
            text += fmt::format("  {} p{}", to_string(entry.value), entry.column);
        text += '\n';
    }
    return text;
}

} // namespace

std::string point_masks_text(const PointMasks& masks) {
    const RationalMatrix& matrix = masks.matrix;
    std::string text =
        fmt::format("{}: {}\n\n{}", printable(masks.name), masks.closed ? "closed" : "open", mask_line(masks));
    text += fmt::format("\n  one cycle on {} {}: {} new ones, a row each\n\n", matrix.columns,
                        matrix.columns == 1 ? "point" : "points", matrix.rows.size());
    return text + (matrix.columns <= most_columns ? dense_rows(matrix) : sparse_rows(matrix));
}

} // namespace internode
