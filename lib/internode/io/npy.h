// SPDX-License-Identifier: MIT
//
// Points as a NumPy array file, version 1.0: little-endian doubles `<f8` in C order, shape (N, dimension).

#pragma once

#include "internode/io/file/sink.h"
#include "internode/io/points_view.h"

namespace internode {

/// Writes all points, bit for bit; false if the sink failed. \throw std::invalid_argument for rows that are not whole
bool write_npy(Sink& sink, const PointsView& points);

} // namespace internode
