// SPDX-License-Identifier: MIT
//
// The piece of a word round a cell, by letters and exact numbers, and what becomes of it in one cycle.
//
// A piece has at most W modules to each side of the cell's own. Where words start is marked: the first point of a word
// owns the modules before it, in a ring too, so that cells stand in the order of the interpreter's word.

#pragma once

#include "internode/point/compile/exact_word.h"
#include "internode/point/compile/module_kind.h"
#include "internode/stencil/cell_rules.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace internode {

struct CellPiece {
    std::vector<std::uint32_t> kinds;
    std::vector<std::uint32_t> starts; ///< a word starts before these modules, ascending; at most kinds.size()
    std::uint32_t center = 0;          ///< the cell's module
    std::uint32_t slot = 0;            ///< which of its points the cell is
    bool left_open = true;
    bool right_open = true;
    friend auto operator<=>(const CellPiece&, const CellPiece&) = default;
};

/// A cell that a cell becomes: its piece, and the rows of all cells in that piece over the parents round the old cell.
struct PieceChild {
    CellPiece piece;
    std::ptrdiff_t first = 0; ///< the cell of the first row, relative to the child
    std::vector<CellRow> rows;
};

/// What a piece becomes. The piece is too narrow: neither children nor a stop.
struct PieceChildren {
    std::optional<std::vector<PieceChild>> children;
    std::optional<ExactStop> stop;
};

/// The modules of a piece that its cell owns: first … last - 1; none where the piece does not tell.
struct OwnModules {
    std::size_t first = 0;
    std::size_t last = 0;
};
[[nodiscard]] std::optional<OwnModules> own_modules(const CellPiece& piece, const KindTable& kinds);

/// One cycle of the piece.
[[nodiscard]] PieceChildren children_of(const CellPiece& piece, const PointSystem& system, KindTable& kinds,
                                        std::size_t side, ExactBudget& budget);

/// A row that no kernel takes.
[[nodiscard]] ExactStop too_wide();

/// The piece round a point of a word that starts at its first module; its modules before and after are the word's, of a
/// ring again and again.
[[nodiscard]] CellPiece piece_of_word(const ExactWord& word, bool ring, std::size_t module, std::uint32_t slot,
                                      std::size_t side, KindTable& kinds);

} // namespace internode
