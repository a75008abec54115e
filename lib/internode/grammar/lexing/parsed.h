// SPDX-License-Identifier: MIT
//
// What reading a text gives: a value, or every error of the text.

#pragma once

#include "internode/text/diagnostic.h"

#include <optional>
#include <vector>

namespace internode {

template<class Value>
struct Parsed {
    std::optional<Value> grammar;   ///< present iff errors is empty
    std::vector<Diagnostic> errors; ///< all errors, in the order of their places
};

} // namespace internode
