// SPDX-License-Identifier: MIT
//
// What `reverse` says of a point grammar: the rule, the polygon of every level down, and how far each is from the one
// above it.

#pragma once

#include "internode/curve/reverse/resampling.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/point/infer/reversal.h"
#include "internode/report/generator.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct ReversalReport {
    std::string source; ///< base name of the polygon's file
    std::string name;   ///< the grammar's, for people
    Fitting fitting;    ///< what was done to the polygon
    std::size_t dimension = 2;
    std::uint64_t phase = 0;
    std::optional<ReverseRule> rule; ///< derived from the grammar; none: it reduces by itself, and errors are not known
    std::vector<std::vector<double>> polygons; ///< the fine one first
    std::vector<ReversedLevel> levels;         ///< errors of each level down, with a rule: one less than polygons
    Generator generator;
};

} // namespace internode
