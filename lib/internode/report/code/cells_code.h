// SPDX-License-Identifier: MIT
//
// The cell automaton of a point grammar as a program's source (code/automaton_code.h is that of an interval grammar).

#pragma once

#include "internode/report/point_masks.h"

#include <string>

namespace internode {

/// A header for C99 and C++11: tables, the start states, NAME_count and NAME_step. Every point is the sum of all
/// weights of its row in order; without contraction it is the same everywhere.
[[nodiscard]] std::string cells_c(const CellExport& cells);

/// A piece of GLSL 4.30 for a compute shader, as automaton_glsl writes it.
[[nodiscard]] std::string cells_glsl(const CellExport& cells);

} // namespace internode
