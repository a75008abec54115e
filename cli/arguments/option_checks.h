// SPDX-License-Identifier: MIT
//
// What the value of an option must be, in CLI11's form of a check: a text says what is wrong, an empty one nothing.

#pragma once

#include "internode/stencil/isa.h"
#include "internode/stencil/stores.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode::cli {

/// The number of a text that is digits and nothing else, within 64 bits.
[[nodiscard]] std::optional<std::uint64_t> whole_number(const std::string& text);

/// The same with `-` before it where it is negative.
[[nodiscard]] std::optional<std::int64_t> integer(const std::string& text);

/// One degree of a B-spline, or two with a comma between them; nothing for any other text.
[[nodiscard]] std::vector<int> degrees(std::string_view text);

[[nodiscard]] std::string whole_number_problem(const std::string& text);
[[nodiscard]] std::string integer_problem(const std::string& text);
[[nodiscard]] std::string positive_number(const std::string& text);
[[nodiscard]] std::string empty_word_problem(const std::string& text);

/// What INTERNODE_ISA in the environment asks for; Best when it says nothing. \throw Failure (Usage)
[[nodiscard]] Isa isa_of_environment();

/// What INTERNODE_STORES in the environment asks for; Measured when it says nothing. \throw Failure (Usage)
[[nodiscard]] Stores stores_of_environment();

} // namespace internode::cli
