// SPDX-License-Identifier: MIT
//
// A curve as JSON of format "internode-curve": what read_polygon_json reads, written as it is computed.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/io/points_view.h"
#include "internode/word/symbol.h"

#include <span>
#include <string>
#include <vector>

namespace internode {

/// The length of a symbol's interval: Σ exact[i] ρ^i.
struct CurveLength {
    std::string symbol;
    double value = 0;               ///< correctly rounded
    std::vector<std::string> exact; ///< low degree first; without it the length cannot be read back and is left out
};

/// Where a parameter begins: Σ exact[i] ρ^i.
struct CurveOrigin {
    double value = 0;               ///< correctly rounded
    std::vector<std::string> exact; ///< low degree first; the key is left out when empty
};

struct CurveDocument {
    std::string version; ///< the version of internode, for "generator"
    std::string command; ///< the command that made the curve, for "generator": base names, no output name
    std::size_t degree = 1;
    Ends ends = Ends::Open;
    std::vector<std::string> symbols; ///< names of the letters of `word`
    WordView word;                    ///< the key is left out when empty
    std::vector<CurveLength> lengths; ///< the key is left out when empty
    CurveOrigin origin;
    std::vector<double> knots; ///< rounded, for the eye and for a check; the key is left out when empty
    PointsView points;
    bool weighted = false; ///< the last coordinate of each row goes into "weights" instead
    int threads = 1;       ///< that make the text; 0: as many as the machine has
};

/// Several as one document of format "internode-curves", in which each is a whole "internode-curve". Return and
/// exceptions as of the other.
bool write_curves_json(Sink& sink, std::span<const CurveDocument> curves);

/// Writes the document; false if the sink failed. \throw std::invalid_argument for rows that are not whole and numbers
/// that are not finite, weights without another coordinate; std::out_of_range for a letter without a name
bool write_curve_json(Sink& sink, const CurveDocument& curve);

} // namespace internode
