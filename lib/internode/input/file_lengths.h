// SPDX-License-Identifier: MIT
//
// From what a file says of lengths, knots and origin to numbers of the field, and to the system that has them. Not
// installed.

#pragma once

#include "internode/curve/knot_vector.h"
#include "internode/curve/knots.h"
#include "internode/io/polygon.h"

namespace internode {

/// "`X` is no symbol of the grammar", at its place.
[[nodiscard]] Diagnostic unknown_symbol(const PlacedText& name, const std::string& source, const Alphabet& alphabet);

/// "A1" … as the language has them, so that no name of a file is stranger than a grammar's.
[[nodiscard]] bool is_symbol_name(const std::string& name);

/// A diagnostic at a piece of the user's text.
[[nodiscard]] Diagnostic diagnostic_at(const PlacedText& text, const std::string& source, std::string message);

/// The lengths as positive numbers of the field. \throw Refused with every fault, at its place
[[nodiscard]] std::vector<FixedLength>
positive_lengths(const IntervalSystem& system, const std::vector<InputLength>& lengths, const std::string& source);

/// The system with the lengths that the file fixes. Where a grammar of one symbol meets names of another grammar, it
/// says how each of them splits. \throw Refused with every conflict
[[nodiscard]] IntervalSystem fixed_lengths(const IntervalSystem& system, const InputPolygon& polygon);

/// The lengths of these symbols ρ^levels times as long: those of a polygon so many levels down. \throw Refused where
/// the others do not follow
[[nodiscard]] IntervalSystem scaled_lengths(const IntervalSystem& system, const std::vector<Symbol>& symbols,
                                            int levels);

/// Which knots are meant: those of a curve, or along one side of a grid.
struct KnotShape {
    std::size_t points = 0;
    int degree = 1;
    Ends ends = Ends::Open;
    std::string before{}; ///< how each problem begins: "along u: "
};

/// The word of the knots in the file. \throw Refused with what does not fit
[[nodiscard]] KnotWord word_of_knots(const IntervalSystem& system, const InputPolygon& polygon, const KnotShape& shape);

/// Where the parameter begins: the file's origin, else the first knot of the domain among its knots, else 0.
/// \throw Refused for knots of another number, or an origin that the field has not
[[nodiscard]] Number file_origin(const IntervalSystem& system, const InputPolygon& polygon, const KnotShape& shape);

/// Knots that a file says beside its word must be those of the word: exactly, or rounded as our own files have them.
/// \throw Refused with the first that is not
void require_knots(const InputPolygon& polygon, const Knots& knots, const std::string& before);

} // namespace internode
