// SPDX-License-Identifier: MIT
//
// What follows from the mask of a uniform scheme, as a part of JSON documents.

#pragma once

#include "internode/io/json/json_writer.h"
#include "internode/point/check/point_validation.h"

namespace internode {

/// One object: the mask with its symbol, degrees, names and bounds.
void write_mask_facts(JsonWriter& json, const MaskFacts& facts);

} // namespace internode
