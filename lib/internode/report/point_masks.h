// SPDX-License-Identifier: MIT
//
// The masks of a point grammar: what a cycle does to a polygon of N points, as a matrix, and far from all ends, as the
// mask of a uniform scheme; and the automaton that says both for all N.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/mask/uniform_mask.h"
#include "internode/point/compile/compile.h"
#include "internode/report/generator.h"

#include <optional>
#include <string>

namespace internode {

struct PointMasks {
    std::string name; ///< of the grammar, for people
    bool closed = false;
    RationalMatrix matrix;           ///< of one cycle
    std::optional<UniformMask> mask; ///< none: the rules do not do the same to every point
    Generator generator;
};

/// The mask, and the matrix row by row.
[[nodiscard]] std::string point_masks_text(const PointMasks& masks);

/// "internode-point-masks" version 1 (docs/json.md).
[[nodiscard]] std::string point_masks_json(const PointMasks& masks);

/// The cell automaton of a grammar that compiles, and the states of the word it starts with.
struct CellExport {
    std::string name;
    bool closed = false;
    CompiledGrammar compiled;
    Generator generator;
};

/// "internode-cells" version 1 (docs/json.md): states with offsets and children, exact rows, start states.
[[nodiscard]] std::string cells_json(const CellExport& cells);

/// A header for C99 and C++11: tables, the start states, NAME_count and NAME_step. Every point is the sum of all
/// weights of its row in order; without contraction it is the same everywhere.
[[nodiscard]] std::string cells_c(const CellExport& cells);

/// A piece of GLSL 4.30 for a compute shader, as automaton_glsl writes it.
[[nodiscard]] std::string cells_glsl(const CellExport& cells);

} // namespace internode
