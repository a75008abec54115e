// SPDX-License-Identifier: MIT
//
// The points of a point grammar on their way out.

#pragma once

#include "cli/points/points.h"
#include "internode/io/file/sink.h"
#include "internode/point/strands.h"

#include <cstdint>
#include <string>

namespace internode::cli {

/// Divides homogeneous points by their weights, which go; points that the grammar has projected itself stay.
/// \throw Failure (Refused) for weights that are not positive
void project(PointStrands& strands, const LoadedPoints& loaded);

/// In CSV, JSON, NPY or OBJ. Homogeneous points that the grammar has not projected itself are divided by their weights,
/// which follow as a last column, or stand apart; OBJ leaves them out. \throw Failure (Refused) for a word without
/// points and for weights that are not positive
void write_points(Sink& sink, const std::string& format, PointStrands strands, const LoadedPoints& loaded,
                  std::uint64_t cycles, const Context& context);

} // namespace internode::cli
