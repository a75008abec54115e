// SPDX-License-Identifier: MIT
//
// A pyramid as its file gives it (io/json/pyramid_json.h), settled: the grammar proved valid again, lengths and sizes
// held against its words.

#pragma once

#include "internode/curve/reverse/pyramid.h"
#include "internode/input/refusal.h"
#include "internode/io/json/pyramid_json.h"

namespace internode {

/// Cost: that of validate(), and linear in the details.
[[nodiscard]] Settled<Pyramid> settle_pyramid(const InputPyramid& input);

} // namespace internode
