// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/normal_form.h"

#include "internode/grammar/lexing/limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

void check_normal_form(std::string_view printed, Complaints& complaints) {
    std::size_t longest = 0;
    std::size_t line = 0;
    for (const char byte : printed) {
        line = byte == '\n' ? 0 : line + 1;
        longest = std::max(longest, line);
    }
    const auto refuse = [&](std::string_view what, std::size_t bytes, std::size_t limit) {
        complaints.add("grammar.normal-form-too-large", {0, 1},
                       fmt::format("written out, this makes a {} of {} bytes, more than {}", what, bytes, limit));
    };
    if (longest > max_line_bytes) refuse("line", longest, max_line_bytes);
    if (printed.size() > max_grammar_bytes) refuse("text", printed.size(), max_grammar_bytes);
}

} // namespace internode
