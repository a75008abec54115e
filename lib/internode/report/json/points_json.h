// SPDX-License-Identifier: MIT
//
// What a point grammar made of a polygon, as JSON of format "internode-points" (docs/json.md): the points of the last
// word, how they are joined, and the lines that the word has of its own. Of several polygons, "internode-parts".

#pragma once

#include "internode/io/file/sink.h"
#include "internode/point/strands.h"
#include "internode/report/generator.h"

#include <cstdint>
#include <span>
#include <string>

namespace internode {

struct PointsDocument {
    std::string name;         ///< the grammar's
    std::uint64_t cycles = 0; ///< cycles from the axiom or the polygon to the points
    bool weighted = false;    ///< the last coordinate of each point goes into "weights" instead
    Generator generator;
    int threads = 1; ///< that make the text of the points; 0: as many as the machine has
};

/// Writes the document; false if the sink failed. \throw std::invalid_argument for numbers that are not finite, and for
/// weights without another coordinate
bool write_points_json(Sink& sink, const PointStrands& strands, const PointSystem& system,
                       const PointsDocument& document);

/// What became of one polygon of several.
struct PointsPart {
    const PointStrands& strands;
    const PointSystem& system;
    PointsDocument document;
};

/// Several as one document of format "internode-parts", in which each is a whole "internode-points". Return and
/// exceptions as of the other.
bool write_parts_json(Sink& sink, std::span<const PointsPart> parts);

} // namespace internode
