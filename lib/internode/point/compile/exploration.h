// SPDX-License-Identifier: MIT
//
// Every piece of a word that can stand round a cell, found from the start word cycle by cycle: the states of an
// automaton before any are merged.

#pragma once

#include "internode/point/compile/cell_piece.h"
#include "internode/point/compile/start_cells.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace internode {

struct ExploredState {
    CellPiece piece;
    std::vector<PieceChild> children;
    std::vector<std::uint32_t> states; ///< the states of the children, one each
};

struct Exploration {
    std::size_t side = 1; ///< modules of a piece to each side of its cell's
    KindTable kinds;
    std::vector<ExploredState> states;
    std::vector<std::uint32_t> starts; ///< states of the cells of the shown start word, at least one
};

/// Pieces of that width decide: `exploration`. They never will: `stop` says why. They are too narrow: neither.
struct ExplorationResult {
    std::optional<Exploration> exploration;
    std::optional<ExactStop> stop;
};

/// `budget` goes down by what is written. \throw std::invalid_argument as shown_word()
[[nodiscard]] ExplorationResult explore(const PointSystem& system, StartWord start, std::size_t side,
                                        std::size_t most_states, ExactBudget& budget);

} // namespace internode
