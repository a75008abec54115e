// SPDX-License-Identifier: MIT
//
// The incidence matrix M of a grammar and the strongly connected classes of its graph (Nivoliers et al. 2012, eq. 4 and
// Definition 3.4). Both are of the symbols that can occur: all of them without an axiom, else those that the axiom
// produces. Symbols that cannot occur have an empty row and belong to no class; the letter `0` has no row at all.

#pragma once

#include "internode/algebra/perron.h"
#include "internode/grammar/intervals/interval_grammar.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace internode {

/// The class of a symbol that cannot occur; the home of a class that leads to several final classes.
inline constexpr std::uint32_t no_class = std::numeric_limits<std::uint32_t>::max();

struct IntervalClass {
    std::vector<std::uint32_t> members;    ///< symbols, ascending
    std::vector<std::uint32_t> successors; ///< other classes that its rules name, each once
    bool final = false;                    ///< no arc leaves it
    std::size_t period = 0;                ///< period of the cycles of the class; 0 = no cycle
    std::uint32_t home = no_class;         ///< the only final class it leads to, or no_class for several
    SparseMatrix block;                    ///< M restricted to the members
};

struct ClassGraph {
    SparseMatrix matrix;                 ///< n rows
    std::vector<std::uint32_t> class_of; ///< index in classes of each symbol, or no_class
    std::vector<IntervalClass> classes;  ///< successors come first
};

/// Linear in the letters of all rules, but for a logarithm.
[[nodiscard]] ClassGraph class_graph(const IntervalGrammar& grammar);

/// Whether some rule of the class puts two of its own symbols in the place of one: its ratio is then above 1.
[[nodiscard]] bool splits(const IntervalClass& one);

[[nodiscard]] SparseMatrix transposed(const SparseMatrix& matrix);

} // namespace internode
