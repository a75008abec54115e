// SPDX-License-Identifier: MIT
//
// What settlement gives: a value, or why there is none. Nothing of this room throws for what a file or a caller says.

#pragma once

#include "internode/text/diagnostic.h"

#include <optional>
#include <vector>

namespace internode {

struct Refusal {
    std::vector<Diagnostic> errors; ///< without source, or without line, where no place of a text is to blame
    bool unsaid = false;            ///< the caller has said too little or too much; else the data is refused
};

template<typename Value>
struct Settled {
    std::optional<Value> value;
    Refusal refusal; ///< its errors: at least one iff there is no value
};

} // namespace internode
