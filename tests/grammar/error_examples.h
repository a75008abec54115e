// SPDX-License-Identifier: MIT
//
// A text for every error that the language can give: "Every error" of docs/language.md is written from this table.

#pragma once

#include "internode/text/diagnostic.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode::tests {

enum class ReadAs {
    AnyKind,   ///< by parse
    Intervals, ///< by parse_grammar
    Points,    ///< by parse_point_grammar
    Word,      ///< by parse_word, over the symbols L and S
};

/// The text is begin, then `repeated` so many times, then end; `%` in what is repeated is the number of the time.
struct ErrorExample {
    std::string_view code;
    std::string_view begin;
    ReadAs read = ReadAs::AnyKind;
    std::size_t times = 0;
    std::string_view repeated = {};
    std::string_view end = {};
};

/// In the order of the page: by the part of the language that the code names.
[[nodiscard]] std::span<const ErrorExample> error_examples();

[[nodiscard]] std::string text_of(const ErrorExample& example);

/// Every error of the text of one of error_examples().
[[nodiscard]] const std::vector<Diagnostic>& errors_of(const ErrorExample& example);

/// The section of the page: for each code the example, and the error with its place and its hint.
[[nodiscard]] std::string error_page();

} // namespace internode::tests
