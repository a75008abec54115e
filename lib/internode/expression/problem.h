// SPDX-License-Identifier: MIT
//
// What is wrong with an expression or with the grammar that holds it: a fact about the text, which a user has to mend.

#pragma once

#include "internode/expression/expression.h"

#include <string>

namespace internode {

struct ExpressionProblem {
    SourcePlace place; ///< the expression, or what holds it; bytes 0 when the whole text is meant
    std::string message;
    std::string hint; ///< may be empty
};

} // namespace internode
