// SPDX-License-Identifier: MIT
//
// Which interval grammar is the same scheme as a point grammar: `intervals A -> A … A` with m letters, at degree d, has
// the uniform B-splines for masks.

#pragma once

#include "internode/point/compile/compiled_grammar.h"

#include <cstddef>
#include <optional>

namespace internode {

struct IntervalTwin {
    std::size_t arity = 2; ///< letters of the rule of A
    int degree = 1;
    /// So many new points were moved from each cell to the one before it to make the normal forms equal; 0: none.
    std::size_t moved = 0;
};

/// The twin, by comparison of the normal forms (stencil/cell_rules.h); none when there is none of degree 1 … 12.
[[nodiscard]] std::optional<IntervalTwin> interval_twin(const CompiledGrammar& compiled);

} // namespace internode
