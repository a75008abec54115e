// SPDX-License-Identifier: MIT
//
// What the library settles, as a command takes it: the value, or the end of the command with the library's words.

#pragma once

#include "cli/requests/exit_code.h"
#include "internode/input/refusal.h"

#include <utility>

namespace internode::cli {

/// Usage when the caller must say something else, Refused when the data does not fit.
[[nodiscard]] Failure failure(const internode::Refusal& refusal);

/// \throw Failure
template<typename Value>
[[nodiscard]] Value value_of(Settled<Value> settled) {
    if (!settled.value) throw failure(settled.refusal);
    return *std::move(settled.value);
}

} // namespace internode::cli
