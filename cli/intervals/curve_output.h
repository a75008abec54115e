// SPDX-License-Identifier: MIT
//
// A curve on its way out as a curve's JSON.

#pragma once

#include "cli/requests/options.h"
#include "internode/curve/curve.h"
#include "internode/io/file/sink.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/points_view.h"

namespace internode::cli {

/// Word, points, the lengths at the curve's step, a_i / ρ^s, and where its parameter begins: the file reads back as the
/// same curve.
void write_curve(Sink& sink, const Curve& curve, const Context& context);

/// The same as a document, with `points` as they shall stand there; with `weighted` the last coordinate of each is its
/// weight. Curve and points must outlive it.
[[nodiscard]] CurveDocument curve_document(const Curve& curve, const PointsView& points, bool weighted,
                                           const Context& context);

} // namespace internode::cli
