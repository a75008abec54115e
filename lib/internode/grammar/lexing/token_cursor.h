// SPDX-License-Identifier: MIT
//
// A place in a sequence of tokens, which may be inside a run: `2x` is a number and a name, `IP` two letters.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/token.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace internode {

class TokenCursor {
public:
    /// The tokens must outlive the cursor.
    TokenCursor(std::span<const Token> tokens, std::string_view text)
        : tokens_(tokens)
        , text_(text) {}

    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] bool at_end() const { return index_ == tokens_.size(); }
    /// None of these may be asked at the end, but for at_mark and is_run.
    [[nodiscard]] const Token& token() const { return tokens_[index_]; }
    [[nodiscard]] std::size_t index() const { return index_; }
    [[nodiscard]] std::size_t offset() const { return token().begin + inside_; }
    [[nodiscard]] Complaints::Place place() const { return {offset(), token().bytes - inside_}; }
    /// The bytes of the token from here on.
    [[nodiscard]] std::string_view rest() const { return text_.substr(offset(), token().bytes - inside_); }

    [[nodiscard]] bool is_run(std::size_t ahead = 0) const {
        return index_ + ahead < tokens_.size() && tokens_[index_ + ahead].kind == TokenKind::Run;
    }
    [[nodiscard]] bool at_mark(char mark, std::size_t ahead = 0) const {
        return index_ + ahead < tokens_.size() && is_mark(tokens_[index_ + ahead], text_, mark);
    }
    /// Whether a token follows the one `ahead` without a blank between them.
    [[nodiscard]] bool is_joined(std::size_t ahead = 0) const {
        if (index_ + ahead + 1 >= tokens_.size()) return false;
        const Token& first = tokens_[index_ + ahead];
        return first.begin + first.bytes == tokens_[index_ + ahead + 1].begin;
    }
    [[nodiscard]] std::size_t offset_ahead(std::size_t ahead) const { return tokens_[index_ + ahead].begin; }
    [[nodiscard]] std::string_view text_ahead(std::size_t ahead) const {
        return text_of(tokens_[index_ + ahead], text_);
    }

    void next() {
        ++index_;
        inside_ = 0;
    }
    void advance(std::size_t bytes) {
        inside_ += bytes;
        if (inside_ >= token().bytes) next();
    }
    /// To a later place of the text, inside a token or at its begin.
    void move_to(std::size_t offset) {
        while (!at_end() && token().begin + token().bytes <= offset) next();
        if (!at_end() && token().begin < offset) inside_ = offset - token().begin;
    }

private:
    std::span<const Token> tokens_;
    std::string_view text_;
    std::size_t index_ = 0;
    std::size_t inside_ = 0; ///< bytes of the token read already
};

/// The end of the number that begins `ahead` tokens from here (`3`, `0.25`, `.5`); the begin of the token if none does.
[[nodiscard]] std::size_t end_of_number(const TokenCursor& cursor, std::size_t ahead = 0);

} // namespace internode
