// SPDX-License-Identifier: MIT
//
// A name in an expression that stands for nothing: what is wrong with it, and what may be meant.

#pragma once

#include "internode/grammar/expressions/name_scope.h"
#include "internode/grammar/lexing/complaints.h"

#include <cstddef>
#include <string_view>

namespace internode {

struct UnknownName {
    std::string_view name;
    Complaints::Place place;
    bool is_call = false;        ///< a parenthesis follows
    bool touches_number = false; ///< a number stands before it without a blank: `1e`
};

/// `searches` counts the searches for near names in a whole text: only as many as errors are shown are worth the time.
void complain_of(const UnknownName& unknown, const NameScope& scope, std::size_t& searches, Complaints& complaints);

} // namespace internode
