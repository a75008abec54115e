// SPDX-License-Identifier: MIT
//
// The word that a derivation starts from, with its numbers and without its points: of many points, as much of it as
// shows every cell.

#pragma once

#include "internode/point/compile/exact_word.h"
#include "internode/point/limits.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace internode {

/// The word that a derivation starts with: of a polygon of so many points, or the axiom.
struct StartWord {
    std::optional<std::size_t> points;
};

/// A number of points whose ends do not see each other: any scheme in general.
inline constexpr std::size_t many_points = std::size_t{1} << 20;

/// Limits of compiling (point/limits.h).
struct CompileLimits {
    std::size_t side = max_compiled_side;
    std::size_t states = max_compiled_states;
    std::uint64_t work = max_compile_work; ///< exact work, as an ExactBudget counts it
};

/// Points of the start word that are looked at with pieces of `side` modules to each side: the others have the cells of
/// the middle ones. Every point gives at least one module, so a piece sees at most `side` points to each side.
[[nodiscard]] std::size_t shown_points(std::size_t points, std::size_t side);

/// \throw std::invalid_argument for no points, or an input or an axiom that the grammar does not have
void require_start(const PointSystem& system, StartWord start);

/// The word of the shown points, or of the axiom: numbers are exact, points new ones. \throw std::invalid_argument as
/// require_start()
[[nodiscard]] std::variant<ExactWord, ExactStop> shown_word(const PointSystem& system, StartWord start,
                                                            std::size_t side);

/// The states of all cells of the start word from those of the shown ones.
struct CellsOfStart {
    std::vector<std::uint32_t> states;
    std::optional<std::uint32_t> interior; ///< state of a cell in the middle, where not all points are shown
};
[[nodiscard]] CellsOfStart start_cells(const std::vector<std::uint32_t>& shown, const PointSystem& system,
                                       StartWord start, std::size_t side);

} // namespace internode
