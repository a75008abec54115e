// SPDX-License-Identifier: MIT
//
// Texts with the errors that they must give.

#pragma once

#include "internode/text/diagnostic.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace internode::tests {

struct ErrorCase {
    std::string text;
    std::string errors; ///< "line:column message | hint", a line each
};

inline std::string error_lines(const std::vector<Diagnostic>& errors) {
    std::string result;
    for (const Diagnostic& error : errors) {
        result += fmt::format("{}:{} {}", error.line, error.column, error.message);
        result += error.hint.empty() ? "\n" : fmt::format(" | {}\n", error.hint);
    }
    return result;
}

/// \param errors_of the errors that a parser finds in a text
inline void expect_errors(const std::vector<ErrorCase>& cases,
                          const std::function<std::vector<Diagnostic>(std::string_view)>& errors_of) {
    for (const auto& [text, errors] : cases) EXPECT_EQ(error_lines(errors_of(text)), errors) << text;
}

} // namespace internode::tests
