// SPDX-License-Identifier: MIT
//
// The masks of a point grammar: what a cycle does to a polygon of N points, as a matrix and, far from all ends, as the
// mask of a uniform scheme. The automaton says both for all N.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/mask/uniform_mask.h"
#include "internode/point/compile/compile.h"
#include "internode/report/generator.h"

#include <optional>
#include <string>

namespace internode {

struct PointMasks {
    std::string name; ///< the grammar's, for people
    bool closed = false;
    RationalMatrix matrix;           ///< the matrix of one cycle
    std::optional<UniformMask> mask; ///< none: the rules do not do the same to every point
    Generator generator;
};

/// The cell automaton of a grammar that compiles, and the states of the word it starts with.
struct CellExport {
    std::string name; ///< the grammar's, for people
    bool closed = false;
    CompiledGrammar compiled;
    Generator generator;
};

} // namespace internode
