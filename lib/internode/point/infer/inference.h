// SPDX-License-Identifier: MIT
//
// From a subdivision matrix, new points = matrix * old points, to the production that says the same without indices
// (Prusinkiewicz, Samavati, Smith, Karwowski 2003, section 5; section 6 for open curves).
//
// Away from the ends row m q + r of the matrix is one stencil for each r = 0 … m-1, moved to old point q. Which new
// points an old one is replaced by is a choice, the shift d: old point i takes the new points m i + d … m i + d + m-1,
// all counted from 0. That is S0's P(j-1) P(j) with j = 2i + d, counted from 1: d = 0 is S0 eq. 13, d = -1 and 1 are
// eq. 17 and 18. Eq. 20, which the paper calls d = 3, is d = 5 by its own formula and by its picture, eq. 19.
//
// A matrix of one size cannot prove a pattern for all sizes. Taken for the pattern is the narrowest one that fits every
// row; a matrix in which that is not unique is refused.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/point/infer/production.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

/// A row that breaks the pattern which the row `like` has; both from 0.
struct IrregularRow {
    std::size_t row = 0;
    std::size_t like = 0;
};

/// Why nothing was inferred.
struct InferenceProblem {
    std::string message;
    std::string hint;               ///< may be empty
    std::vector<IrregularRow> rows; ///< ascending
};

/// The production of one shift.
struct ShiftedProduction {
    std::ptrdiff_t shift = 0;
    PointProduction production; ///< contexts as short as the stencils allow
};

/// What the regular rows say.
struct RowPattern {
    std::size_t rows = 0;    ///< rows of the matrix, the new points
    std::size_t columns = 0; ///< columns of the matrix, the n old points
    /// m of them: new point m q + r is stencils[r] about old point q, whatever the shift.
    std::vector<PointStencil> stencils;
    std::vector<std::size_t> not_affine; ///< rows of the matrix whose weights do not sum to 1, ascending
    [[nodiscard]] std::size_t arity() const { return stencils.size(); }
};

/// Wider patterns are refused: ranking their shifts would be slow, and no scheme has them.
inline constexpr std::size_t max_inferred_arity = 64;
inline constexpr std::size_t max_pattern_size = 4096; ///< arity times old points from the first to the last

struct InferredPattern {
    std::optional<RowPattern> pattern;
    std::optional<InferenceProblem> problem; ///< present iff pattern is not
};

/// Of a closed curve: m n rows and n columns, column numbers round the ring. Refused: another number of rows, an
/// irregular row, and too few columns to see where a stencil begins. Cost: linear in the entries, times log.
[[nodiscard]] InferredPattern infer_closed(const RationalMatrix& matrix);

/// Of any integer shift. Cost: linear in the pattern.
[[nodiscard]] ShiftedProduction production_of(const RowPattern& pattern, std::ptrdiff_t shift);

/// The shifts in which some new point depends on the old point that it replaces, ascending; at most max_listed_shifts,
/// those round the recommended one. The recommended shift has the largest own weight; of equals the fewest context
/// modules, then the one whose first new points lie nearer (S0 eq. 22 and 25), then the smallest |d|.
struct ShiftList {
    std::vector<std::ptrdiff_t> shifts;
    std::ptrdiff_t recommended = 0;
};
inline constexpr std::size_t max_listed_shifts = 64;
[[nodiscard]] ShiftList sensible_shifts(const RowPattern& pattern);

/// Of an open curve: a pattern between two blocks of rows that are as they are.
struct OpenPattern {
    RowPattern pattern;
    std::size_t first_regular = 0; ///< row from which the pattern holds
    std::size_t end_regular = 0;   ///< row from which it no longer holds
    RationalMatrix matrix;
};

struct InferredOpenPattern {
    std::optional<OpenPattern> pattern;
    std::optional<InferenceProblem> problem; ///< present iff pattern is not
};

/// Any numbers of rows and columns. Refused: no rows that repeat m rows further on and one column to the right for two
/// periods, irregular rows among regular ones, end rows that reach the other end.
[[nodiscard]] InferredOpenPattern infer_open(const RationalMatrix& matrix);

/// The rules of an open curve for one shift: the old points near an end have productions of their own. The first old
/// point takes all rows before those of the second, the last all that are left.
struct OpenProductions {
    ShiftedProduction inner;
    std::vector<PointProduction> first; ///< productions of old points 0, 1, …, each with the marker on the left
    std::vector<PointProduction> last;  ///< those of the last old point, the one before it, …: marker on the right
    std::size_t least_points = 0;       ///< old points from which on both forms say what the matrix says
};

struct InferredOpenProductions {
    std::optional<OpenProductions> productions;
    std::optional<InferenceProblem> problem; ///< present iff productions is not: too small for this shift
};
[[nodiscard]] InferredOpenProductions open_productions(const OpenPattern& pattern, std::ptrdiff_t shift);

/// Those of sensible_shifts() that have productions; of shifts alike in the weight and the contexts of the inner rule
/// the one with fewer end rules is recommended. Empty when none has.
[[nodiscard]] ShiftList sensible_open_shifts(const OpenPattern& pattern);

enum class OpenForm {
    Long,    ///< S0 eq. 28 to 33: contexts keep the inner rule away from the ends, no two rules fit one point
    Ordered, ///< S0 eq. 34 to 36: the first rule that fits is taken, and points that stay need no rule
};

[[nodiscard]] PointGrammar closed_grammar(std::string name, const ShiftedProduction& production);
[[nodiscard]] PointGrammar open_grammar(std::string name, const OpenProductions& productions, OpenForm form);

} // namespace internode
