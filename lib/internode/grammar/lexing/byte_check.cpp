// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/byte_check.h"

#include "internode/grammar/lexing/limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

void check_bytes(std::string_view text, std::span<const Token> tokens, Complaints& complaints) {
    for (const Token& token : tokens) {
        if (token.kind != TokenKind::Broken) continue;
        const unsigned byte = static_cast<unsigned char>(text[token.begin]);
        if (byte >= 0x80)
            complaints.add("text.not-utf8", place_of(token), fmt::format("the byte \\x{:02X} is not UTF-8", byte),
                           "save the text as UTF-8");
        else
            complaints.add("text.control-character", place_of(token),
                           fmt::format("the control character \\x{:02X}", byte), "a grammar is plain text");
    }
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
        if (end - start > max_line_bytes)
            complaints.add("text.line-too-long", {start, 1},
                           fmt::format("a line of {} bytes, more than {}", end - start, max_line_bytes));
        start = end + 1;
    }
}

} // namespace internode
