// SPDX-License-Identifier: MIT
//
// What the parameters of each letter are: numbers, or points of so many coordinates.

#pragma once

#include "internode/expression/type.h"

#include <optional>
#include <vector>

namespace internode {

/// The parameters of each letter: none where no word has the letter.
using Layout = std::vector<std::optional<std::vector<Extent>>>;

} // namespace internode
