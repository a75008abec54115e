// SPDX-License-Identifier: MIT

#include "internode/point/infer/row_pattern.h"

#include <algorithm>
#include <cassert>

namespace internode {

std::vector<std::size_t> rows_not_affine(const RationalMatrix& matrix) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        Rational sum = 0;
        for (const RationalEntry& entry : matrix.rows[row]) sum += entry.value;
        if (sum != 1) rows.push_back(row);
    }
    return rows;
}

std::optional<InferenceProblem> size_problem(const RowPattern& pattern) {
    assert(pattern.arity() > 0);
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
    for (const PointStencil& stencil : pattern.stencils) {
        if (stencil.empty()) continue;
        first = std::min(first, stencil.front().offset);
        last = std::max(last, stencil.back().offset);
    }
    const auto span = static_cast<std::size_t>(last - first) + 1;
    if (pattern.arity() <= max_inferred_arity && span <= max_pattern_size / pattern.arity()) return std::nullopt;
    return InferenceProblem{"the pattern replaces a point by " + std::to_string(pattern.arity()) +
                                " new ones that depend on " + std::to_string(span) + " old ones; the limits are " +
                                std::to_string(max_inferred_arity) + " new points, and " +
                                std::to_string(max_pattern_size) + " for the product",
                            {},
                            {}};
}

} // namespace internode
