// SPDX-License-Identifier: MIT
//
// What is said about a point grammar from outside, and what can be wrong with it.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/expression/problem.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace internode {

/// Where the words come from. `Any`: the axiom and the input, where the grammar has them; with neither, or with
/// `Input`, points become `P(v)`.
enum class PointStart : std::uint8_t { Any, Axiom, Input };

struct PointSettings {
    std::size_t dimension = 2;                   ///< coordinates of the points of the input, 1 … 64
    std::map<std::string, Rational> constants{}; ///< values of constants, instead of the grammar's
    PointStart start = PointStart::Any;
};

/// A fact about the grammar that a user has to mend.
using PointProblem = ExpressionProblem;

} // namespace internode
