// SPDX-License-Identifier: MIT
//
// Window stencils: how a new control point gathers from the old ones.
//
// The new points that start in the old non-empty interval j depend on the window of 2d-1 intervals j-d+1 … j+d-1 and on
// nothing else (docs/mathematics.md). A row has d+1 weights of v_{j-d} … v_j, one row per child c of j: the blossom of
// the piece over j at the d new knots after the child's start. A new point whose leftmost interval is empty, or lies
// left of an open domain that starts with j, belongs to child 0 of j. It has z = 1 … d new intervals before it: the
// *leading* rows. The same piece gives the Bézier points of the curve over j, and with them its limit at both knots.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/spline/blossom.h"

#include <vector>

namespace internode {

/// A window and its refinement, ready to give rows one at a time; every row is d + 1 weights of v_{j-d} … v_j.
class WindowPiece {
public:
    /// \throw std::invalid_argument for an even window, an empty middle interval, or a symbol without a length
    WindowPiece(const IntervalSystem& system, WordView window);

    [[nodiscard]] std::size_t degree() const { return piece_.degree(); }
    /// How many letters replace the middle one.
    [[nodiscard]] std::size_t child_count() const { return child_count_; }
    /// The 2d - 1 letters of σ(window) around child c < child_count().
    [[nodiscard]] Word child_window(std::size_t c) const;
    [[nodiscard]] std::vector<Number> child(std::size_t c) const;
    /// z = 0 … d new intervals before child 0; z = 0 is child(0).
    [[nodiscard]] std::vector<Number> leading(std::size_t z) const;
    /// The Bézier point b = 0 … d over the middle interval.
    [[nodiscard]] std::vector<Number> bezier(std::size_t b) const;

private:
    struct Refined;
    explicit WindowPiece(Refined refined);
    static Refined refine(const IntervalSystem& system, WordView window);

    Word image_;                ///< σ(window)
    std::vector<Number> knots_; ///< knots of σ(window)
    std::size_t first_;         ///< place of child 0 in image_
    std::size_t child_count_;
    PolynomialPiece piece_; ///< the piece over the middle interval, in units of the refinement
};

/// The windows of the children of the middle letter, without their rows: each 2d - 1 letters of σ(window).
[[nodiscard]] std::vector<Word> child_windows(const Morphism& rules, WordView window);

struct WindowStencils {
    Word window;                     ///< 2d - 1 letters, the middle one not `0`
    std::vector<Word> child_windows; ///< the window of each child of the middle letter: 2d - 1 letters of σ(window)
    std::vector<std::vector<Number>> children; ///< d + 1 weights per child
    std::vector<std::vector<Number>> leading;  ///< d rows, z = 1 … d, of d + 1 weights
};

/// All rows of a window. Exceptions of WindowPiece.
[[nodiscard]] WindowStencils window_stencils(const IntervalSystem& system, WordView window);

/// Rows b = 0 … d of d + 1 weights: the Bézier points, over the middle interval, of the piece with control points
/// v_{j-d} … v_j; row 0 is the limit at τ_j, row d at τ_{j+1}. Exceptions of WindowPiece.
[[nodiscard]] std::vector<std::vector<Number>> bezier_rows(const IntervalSystem& system, WordView window);

/// Where a piece is looked at: at the knot τ_j where its interval begins, or at τ_{j+1} where it ends.
enum class PieceEnd { Begin, End };

/// Rows m = 0 … order of d + 1 weights: the m-th derivatives of the piece at that end, by the parameter in which A_i
/// has the length a_i. After s steps, when it has a_i / ρ^s, row m is to be multiplied by ρ^(s m). Rows beyond m = d
/// are zero. \throw std::invalid_argument for a negative order, and as WindowPiece
[[nodiscard]] std::vector<std::vector<Number>> derivative_rows(const IntervalSystem& system, WordView window,
                                                               PieceEnd end, int order);

} // namespace internode
