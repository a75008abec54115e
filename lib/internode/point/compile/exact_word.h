// SPDX-License-Identifier: MIT
//
// Derivation without rounding, of a whole word or of a piece of one.
//
// A piece ends where nothing is known of what follows, or at an end of the word. In a step, a module of a piece is
// settled when the rule that rewrites it is certain whatever stands beyond the piece; the settled modules round a given
// one are what is left. The meaning is the interpreter's (point/interpreter.h), without queries and chance.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/expression/exact_value.h"
#include "internode/point/limits.h"
#include "internode/point/point_system.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace internode {

struct ExactModule {
    Symbol letter{};
    std::vector<ExactValue> values;
    std::size_t parent = 0; ///< index of the module it comes from, in the word before
    friend bool operator==(const ExactModule&, const ExactModule&) = default;
};

using ExactWord = std::vector<ExactModule>;

/// Why a derivation cannot be exact: the rule or expression, and what it does.
struct ExactStop {
    SourcePlace place;
    std::string reason;
};

/// What is known of the word beyond a piece: at a closed side it ends there.
struct PieceSides {
    bool left_open = false;
    bool right_open = false;
};

/// What may still be written: a module, a term of a point and 64 bits of its weight count 1 each.
struct ExactBudget {
    std::uint64_t left = max_exact_work;
};

/// One derivation step of a whole word; of a ring the contexts go round.
[[nodiscard]] std::variant<ExactWord, ExactStop> exact_step(const PointSystem& system, const ExactWord& word,
                                                            std::optional<std::uint32_t> table, ExactBudget& budget);

/// The same of a piece without brackets. `first` … `last` - 1 are its modules that must be settled; the word holds the
/// successors of all settled ones round them. No word: they are not settled.
struct PieceStep {
    std::optional<ExactWord> word;
    PieceSides sides;
    std::size_t first = 0; ///< first … last - 1 are settled
    std::size_t last = 0;
    std::optional<ExactStop> stop;
};
[[nodiscard]] PieceStep exact_piece_step(const PointSystem& system, const ExactWord& piece, PieceSides sides,
                                         std::size_t first, std::size_t last, std::optional<std::uint32_t> table,
                                         ExactBudget& budget);

/// The word that the input makes of `count` points, p_0 … p_{count-1}. \throw std::invalid_argument for no points, or
/// no input
[[nodiscard]] std::variant<ExactWord, ExactStop> exact_input(const PointSystem& system, std::size_t count);

/// The word of the axiom. \throw std::invalid_argument without one
[[nodiscard]] std::variant<ExactWord, ExactStop> exact_axiom(const PointSystem& system);

/// The matrix of so many cycles on a polygon of `count` points: new points = matrix * old points, every point of every
/// module in the order of the word (S0 eq. 7, 14, 27).
[[nodiscard]] std::variant<RationalMatrix, ExactStop> point_matrix(const PointSystem& system, std::size_t count,
                                                                   std::uint64_t cycles = 1);

} // namespace internode
