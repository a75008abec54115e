// SPDX-License-Identifier: MIT
//
// A text read line by line, with complaints about places in the line at hand.

#pragma once

#include "internode/text/diagnostic.h"
#include "internode/text/place.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace internode {

/// A piece of a line.
struct LinePiece {
    std::string_view text;
    std::size_t offset = 0; ///< bytes of the line before it
};

class TextLines {
public:
    /// All must outlive the lines, and `code`, that of every complaint, the diagnostics. A byte order mark is passed
    /// over.
    TextLines(std::string_view text, std::string_view source, std::string_view code)
        : text_(without_byte_order_mark(text))
        , source_(source)
        , code_(code) {}

    /// Takes the next line, without its end; false when there is none.
    bool next() {
        if (text_.empty()) return false;
        line_ = text_.substr(0, text_.find('\n'));
        text_.remove_prefix(line_.size() < text_.size() ? line_.size() + 1 : text_.size());
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        ++number_;
        return true;
    }

    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; } ///< the number of that line, from 1

    /// A complaint about a piece of the line at hand.
    void refuse(const LinePiece& piece, std::string message, std::string hint = {}) {
        Diagnostic diagnostic = diagnostic_at(line_, piece.offset, source_, std::move(message));
        diagnostic.line = number_;
        diagnostic.width = columns_of(piece.text);
        diagnostic.hint = std::move(hint);
        diagnostic.code = code_;
        errors_.push_back(std::move(diagnostic));
    }

    /// A complaint about the text as a whole.
    void refuse_text(std::string message, std::string hint = {}) {
        Diagnostic diagnostic;
        diagnostic.source = source_;
        diagnostic.message = std::move(message);
        diagnostic.hint = std::move(hint);
        diagnostic.code = code_;
        errors_.push_back(std::move(diagnostic));
    }

    [[nodiscard]] std::vector<Diagnostic>& errors() { return errors_; }

private:
    std::string_view text_; ///< what is not read yet
    std::string_view source_;
    std::string_view code_;
    std::string_view line_;
    std::size_t number_ = 0;
    std::vector<Diagnostic> errors_;
};

/// The pieces between blanks and tabs.
[[nodiscard]] inline std::vector<LinePiece> blank_separated(std::string_view line) {
    std::vector<LinePiece> pieces;
    for (std::size_t end = 0;;) {
        const std::size_t begin = line.find_first_not_of(" \t", end);
        if (begin == std::string_view::npos) return pieces;
        end = std::min(line.find_first_of(" \t", begin), line.size());
        pieces.push_back({line.substr(begin, end - begin), begin});
    }
}

} // namespace internode
