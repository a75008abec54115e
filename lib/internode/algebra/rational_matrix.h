// SPDX-License-Identifier: MIT
//
// A sparse matrix of exact rationals, by rows: a subdivision matrix (new points = matrix * old points) and whatever
// else must not be rounded.

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <vector>

namespace internode {

struct RationalEntry {
    std::size_t column = 0; ///< from 0
    Rational value;         ///< not zero
    friend bool operator==(const RationalEntry&, const RationalEntry&) = default;
};

using RationalRow = std::vector<RationalEntry>; ///< entries by ascending column, none twice

struct RationalMatrix {
    std::size_t columns = 0;
    std::vector<RationalRow> rows;
    friend bool operator==(const RationalMatrix&, const RationalMatrix&) = default;
};

} // namespace internode
