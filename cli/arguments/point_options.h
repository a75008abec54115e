// SPDX-License-Identifier: MIT
//
// Interval grammars and point grammars share commands, not options.

#pragma once

#include "cli/arguments/options.h"

namespace internode::cli {

/// For a point grammar. \throw Failure (Usage) for options of interval grammars
void refuse_curve_options(const SubdivideOptions& options);

/// For an interval grammar. \throw Failure (Usage) for options of point grammars
void refuse_point_options(const PointOptions& options);

} // namespace internode::cli
