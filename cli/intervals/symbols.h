// SPDX-License-Identifier: MIT
//
// From what a polygon's file says of lengths and knots to the system that has them.

#pragma once

#include "internode/curve/knot_vector.h"
#include "internode/io/polygon.h"
#include "internode/text/diagnostic.h"

namespace internode::cli {

/// "`X` is no symbol of the grammar", at its place.
[[nodiscard]] Diagnostic unknown_symbol(const PlacedText& name, const std::string& source, const Alphabet& alphabet);

/// The system with the lengths that the file fixes. Where a grammar of one symbol meets names of another grammar, it
/// says how each of them splits. \throw Failure (Refused) with every conflict
[[nodiscard]] IntervalSystem fixed_lengths(const IntervalSystem& system, const InputPolygon& polygon);

/// The word of the knots in the file, for so many points of a curve or along one side of a grid. \throw Failure
/// (Refused) with what does not fit; `along` stands before each problem
[[nodiscard]] KnotWord word_of_knots(const IntervalSystem& system, const InputPolygon& polygon, std::size_t points,
                                     int degree, Ends ends, const std::string& along = {});

} // namespace internode::cli
