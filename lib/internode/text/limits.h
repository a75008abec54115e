// SPDX-License-Identifier: MIT
//
// A limit by name, as `internode limits` prints it, and the limits that every floor above shares. The others stand in
// the limits.h of the room that refuses.

#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace internode {

struct Limit {
    std::string_view name;
    std::uint64_t value;
    std::string_view unit;
};

inline constexpr std::uint64_t max_dimension = 64;          ///< coordinates of a point
inline constexpr std::uint64_t max_shown_line_bytes = 4096; ///< longer source lines are not quoted

/// What was asked for is larger than a limit that has a name: a refusal, not a mistake of the caller. The message names
/// the limit with its number.
class LimitExceeded : public std::length_error {
public:
    explicit LimitExceeded(const std::string& message)
        : std::length_error(message) {}
};

} // namespace internode
