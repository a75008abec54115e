// SPDX-License-Identifier: MIT
//
// The points of a point grammar on their way out.

#pragma once

#include "cli/points/points.h"
#include "internode/io/file/sink.h"
#include "internode/point/strands.h"

#include <cstdint>
#include <string>
#include <vector>

namespace internode::cli {

/// Divides homogeneous points by their weights, which go; points that the grammar has projected itself stay.
/// \throw Failure (Refused) for weights that are not positive and quotients beyond doubles
void project(PointStrands& strands, const LoadedPoints& loaded);

/// A part as it is written.
struct DrawnPart {
    const LoadedPoints* loaded = nullptr;
    PointStrands strands;
    bool weighted = false; ///< the last coordinate of each point is its weight
};

/// For CSV, JSON, NPY or OBJ. Homogeneous points that the grammar has not projected itself are divided by their
/// weights, which stay as a last coordinate; OBJ leaves them out. The loaded part must outlive it. \throw Failure
/// (Refused) for a word without points, for weights that are not positive and for quotients beyond doubles
[[nodiscard]] DrawnPart drawn_part(PointStrands strands, const LoadedPoints& loaded, const std::string& format);

/// All parts in CSV, JSON or OBJ, the only one in NPY. \throw Failure (Refused) for parts that the format does not hold
void write_points(Sink& sink, const std::string& format, const std::vector<DrawnPart>& parts, std::uint64_t cycles,
                  const Context& context);

} // namespace internode::cli
