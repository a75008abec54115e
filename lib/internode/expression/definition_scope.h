// SPDX-License-Identifier: MIT
//
// What an expression may name beside its formals: the definitions of its text, with the values of the constants.

#pragma once

#include "internode/expression/definition.h"
#include "internode/expression/known_number.h"

#include <span>

namespace internode {

/// Views: both must outlive the scope.
struct DefinitionScope {
    std::span<const Definition> definitions;
    std::span<const KnownNumber> constants; ///< one per definition, or per earlier one; meaningful for constants
};

} // namespace internode
