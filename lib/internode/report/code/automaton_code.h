// SPDX-License-Identifier: MIT
//
// A stencil automaton as code: the tables, and a loop of thirty lines that uses them.
//
// Sums run over all d+1 weights in order, ((w0 p0 + w1 p1) + w2 p2) + …, as the library's do: the C header compiled
// without contraction gives its bytes (docs/promises.md, P11). Names of the user stand in comments only, made inert;
// identifiers are made of the letters and digits of the name.

#pragma once

#include "internode/report/automaton_export.h"
#include "internode/report/generator.h"

#include <string>
#include <string_view>

namespace internode {

/// A header for C99 and C++11: tables, NAME_cells (states from a word), NAME_count and NAME_step.
[[nodiscard]] std::string automaton_c(const AutomatonExport& automaton, const Generator& generator);

/// A piece of GLSL 4.30 for a compute shader: the same tables, one call of NAME_step a cell, buffers and a main().
/// Weights and points are float, or double where INTERNODE_DOUBLE is defined.
[[nodiscard]] std::string automaton_glsl(const AutomatonExport& automaton, const Generator& generator);

/// `text` inside a block comment of C or GLSL: one line, nothing that ends or nests the comment or is not shown.
[[nodiscard]] std::string block_comment_text(std::string_view text);

/// Letters, digits and single inner underscores of `text`, at most 40; `automaton` when there are none. Begins with a
/// letter, and not with `gl_`, which GLSL keeps for itself.
[[nodiscard]] std::string code_identifier(std::string_view text);

} // namespace internode
