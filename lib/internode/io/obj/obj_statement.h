// SPDX-License-Identifier: MIT
//
// The words of an OBJ text, statement by statement: a statement ends with its line, unless `\` continues it; `#` begins
// a comment to the end of the line. Nothing is stored, so that a statement of any length costs nothing. Not installed.

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace internode {

struct ObjWord {
    std::string_view text;
    std::size_t offset = 0; ///< where the word stands in the whole text
};

class ObjWords {
public:
    explicit ObjWords(std::string_view text)
        : text_(text) {}

    /// The next word of this statement, or none at its end.
    std::optional<ObjWord> next();
    /// Goes to the next statement that has a word and takes that word; none at the end of the text.
    std::optional<ObjWord> next_statement();
    /// Where reading stands.
    [[nodiscard]] std::size_t offset() const { return at_; }

private:
    void pass_blanks();
    std::string_view text_;
    std::size_t at_ = 0;
    bool started_ = false;
};

/// What a statement of the format is to the reader of free forms.
enum class ObjStatement {
    Vertex,
    TextureVertex,
    Normal,
    Type,
    Degree,
    Curve,
    Surface,
    PlaneCurve,
    Parameters,
    Trim,
    End,
    Other,
    Foreign,
    Unknown
};
[[nodiscard]] ObjStatement obj_statement(std::string_view keyword);

/// A word between backquotes as messages show it, its first 40 bytes.
[[nodiscard]] std::string obj_quoted(std::string_view word);

/// A statement that the reader knows and that looks like the keyword; empty without one.
[[nodiscard]] std::string obj_did_you_mean(std::string_view keyword);

/// A decimal as OBJ writes it, exactly: parse_rational's, and "+1", "5.", "5.e3"; no fractions.
[[nodiscard]] std::optional<Rational> parse_obj_decimal(std::string_view text);

} // namespace internode
