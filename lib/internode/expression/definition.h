// SPDX-License-Identifier: MIT
//
// A name that a text gives to a number, or to a function of numbers.

#pragma once

#include "internode/expression/expression.h"

#include <string>
#include <vector>

namespace internode {

/// `t = 1/2` or `f(s, t) = min(s, 1) + min(t, 1)`. Uses earlier definitions only.
struct Definition {
    std::string name;
    std::vector<std::string> formals; ///< names of the arguments; none: a constant, which may be set from outside
    Expression value;                 ///< a number
    IncidentalPlace place;
    friend bool operator==(const Definition&, const Definition&) = default;
};

} // namespace internode
