// SPDX-License-Identifier: MIT
//
// The first step of reading: from bytes to tokens. Comments and blanks go; every other byte of the text belongs to
// exactly one token, and a damaged byte is a token too, so that this step cannot fail. One pass, no recursion.

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace internode {

enum class TokenKind : std::uint8_t {
    Run,        ///< letters, digits, `_` and `'` side by side: names, symbols, numbers, zeros
    Text,       ///< "…", with both quotes
    OpenText,   ///< "… without its second quote
    Arrow,      ///< `->` or U+2192
    Mark,       ///< any other printable ASCII character, alone
    Epsilon,    ///< U+03B5
    Comparison, ///< U+2264, U+2265, U+2260
    Foreign,    ///< any other character
    Newline,    ///< LF, CR LF or CR
    Broken,     ///< bytes that are not UTF-8, or control characters
    Unbalanced, ///< a bracket without its partner (never from tokenize)
};

struct Token {
    std::uint32_t begin = 0; ///< offset of the first byte
    std::uint32_t bytes = 0;
    TokenKind kind = TokenKind::Broken;
};

/// All tokens of a text of fewer than 2^32 bytes.
[[nodiscard]] std::vector<Token> tokenize(std::string_view text);

/// The bytes of a token of that text.
[[nodiscard]] constexpr std::string_view text_of(const Token& token, std::string_view text) {
    return text.substr(token.begin, token.bytes);
}

/// Whether the token is that ASCII character.
[[nodiscard]] constexpr bool is_mark(const Token& token, std::string_view text, char mark) {
    return token.kind == TokenKind::Mark && text[token.begin] == mark;
}

} // namespace internode
