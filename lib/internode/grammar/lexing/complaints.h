// SPDX-License-Identifier: MIT
//
// Errors while a text is read: noted by byte offset in any order, handed out by place as diagnostics.
//
// However many errors a text has, at most max_kept_errors of them, the first by place, are kept.

#pragma once

#include "internode/grammar/lexing/token.h"
#include "internode/text/diagnostic.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

class Complaints {
public:
    /// Both must outlive the complaints.
    Complaints(std::string_view text, std::string_view source);

    struct Place {
        std::size_t offset = 0;
        std::size_t bytes = 0; ///< under the caret; 0 marks the place alone
    };
    /// The code is a literal: it must outlive the diagnostics. Codes and their examples: docs/language.md.
    void add(std::string_view code, Place place, std::string message, std::string hint = {});

    [[nodiscard]] bool empty() const { return noted_.empty(); }
    /// The line of a byte, from 1. Cost: logarithmic after the first call.
    [[nodiscard]] std::size_t line_of(std::size_t offset) const;
    /// All complaints in the order of their places. Cost: linear in the text.
    [[nodiscard]] std::vector<Diagnostic> diagnostics() &&;

private:
    struct Note {
        std::string_view code;
        Place place;
        std::size_t order; ///< number of the complaint as it came, to keep those at one place in order
        std::string message;
        std::string hint;
    };
    void keep_the_first();
    [[nodiscard]] Diagnostic locate(const Note& note, std::size_t line, std::size_t column) const;

    std::string_view text_;
    std::string_view source_;
    std::vector<Note> noted_;
    std::size_t added_ = 0;
    mutable std::vector<std::size_t> line_starts_; ///< filled on first use
};

/// A fragment of the text between backquotes, cut when long.
[[nodiscard]] std::string quoted(std::string_view fragment);

[[nodiscard]] Complaints::Place place_of(const Token& token);
/// From the first token to the last; at least one.
[[nodiscard]] Complaints::Place place_of(std::span<const Token> tokens);

} // namespace internode
