// SPDX-License-Identifier: MIT
//
// One entry of a matrix file: a fraction, a decimal, or dots.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/text/lines.h"

#include <optional>
#include <string_view>

namespace internode {

/// `...`, `:`, `⋮`, `⋱`, `⋯`, `…`, `·`, in any number.
[[nodiscard]] bool is_dots(std::string_view text);

void refuse_dots(TextLines& lines, const LinePiece& piece);

/// The number of a piece, or a complaint about it. A leading `+` and a point without digits after it, as some programs
/// write them, are read too.
[[nodiscard]] std::optional<Rational> fraction(TextLines& lines, const LinePiece& piece);

/// The text between ` `, cut when it is long.
[[nodiscard]] std::string quoted(const LinePiece& piece);

} // namespace internode
