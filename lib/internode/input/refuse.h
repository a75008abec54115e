// SPDX-License-Identifier: MIT
//
// How the sources of this room leave off: a Refused is thrown where something does not fit, and caught by settled()
// before it leaves the room. Not installed.

#pragma once

#include "internode/input/refusal.h"

#include <cassert>
#include <string>
#include <utility>
#include <vector>

namespace internode {

struct Refused {
    Refusal refusal;
};

[[noreturn]] void refuse(std::string message, std::string hint = {});
[[noreturn]] void refuse(std::vector<Diagnostic> errors);
/// Every problem, said of a whole source; the hint after the last.
[[noreturn]] void refuse_all(const std::string& source, const std::string& before,
                             const std::vector<std::string>& problems, std::string hint = {});
/// The caller must say something else.
[[noreturn]] void ask(std::string message, std::string hint = {});

/// The value that `make` gives, or the refusal that it leaves off with.
template<typename Make>
[[nodiscard]] auto settled(Make make) -> Settled<decltype(make())> {
    try {
        return {make(), {}};
    } catch (Refused& refused) {
        assert(!refused.refusal.errors.empty());
        return {std::nullopt, std::move(refused.refusal)};
    }
}

/// A value settled elsewhere in the room; its refusal goes on.
template<typename Value>
[[nodiscard]] Value take(Settled<Value> settled) {
    if (!settled.value) throw Refused{std::move(settled.refusal)};
    return *std::move(settled.value);
}

} // namespace internode
