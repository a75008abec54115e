// SPDX-License-Identifier: MIT
//
// Points as comma-separated values: a line of names, a point a line, shortest round-trip numbers, line feeds.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/io/points_view.h"

#include <span>
#include <string>
#include <vector>

namespace internode {

struct CsvOptions {
    std::vector<std::string> header{};   ///< a name per column, no line when empty; quoted where needed
    std::span<const double> parameter{}; ///< a column before the coordinates, one value per point; none when empty
    bool nan_is_missing = false;         ///< a NaN is an empty field
    int threads = 1;                     ///< that make the lines; 0: as many as the machine has
};

/// "x", "y", "z" up to three dimensions, "x1" … "xn" beyond.
[[nodiscard]] std::vector<std::string> coordinate_names(std::size_t dimension);

/// Writes all points; false if the sink failed. \throw std::invalid_argument for sizes that do not match and numbers
/// that are not finite (NaN aside when it is missing)
bool write_csv(Sink& sink, const PointsView& points, const CsvOptions& options = {});

} // namespace internode
