// SPDX-License-Identifier: MIT

#include "internode/io/matrix/fraction_entry.h"

#include <array>

namespace internode {

namespace {

/// What printed matrices have where a reader must go on alone.
constexpr std::array<std::string_view, 6> dot_signs{":", "\u22EE", "\u22F1", "\u22EF", "\u2026", "\u00B7"};

/// Takes one sign off the front.
bool take_dots(std::string_view& text) {
    for (const std::string_view sign : dot_signs)
        if (text.starts_with(sign)) {
            text.remove_prefix(sign.size());
            return true;
        }
    if (!text.starts_with("..")) return false;
    text.remove_prefix(std::min(text.find_first_not_of('.'), text.size()));
    return true;
}

} // namespace

bool is_dots(std::string_view text) {
    if (text.empty()) return false;
    if (text == ".") return true;
    while (!text.empty())
        if (!take_dots(text)) return false;
    return true;
}

void refuse_dots(TextLines& lines, const LinePiece& piece) {
    lines.refuse(piece, "irregular: " + quoted(piece) + " cannot be interpreted",
                 "write the matrix out for one number of points, large enough to show the pattern");
}

std::optional<Rational> fraction(TextLines& lines, const LinePiece& piece) {
    std::string_view text = piece.text;
    if (text.empty()) {
        lines.refuse(piece, "an empty entry where a number is meant", "write 0");
        return std::nullopt;
    }
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    if (text.size() > 1 && text.ends_with('.')) text.remove_suffix(1);
    std::optional<Rational> value = parse_rational(text);
    if (!value) lines.refuse(piece, quoted(piece) + " is neither a fraction nor a decimal number", "write 3/4 or 0.75");
    return value;
}

std::string quoted(const LinePiece& piece) {
    constexpr std::size_t shown = 40;
    return '`' + std::string(piece.text.substr(0, shown)) + (piece.text.size() > shown ? "...`" : "`");
}

} // namespace internode
