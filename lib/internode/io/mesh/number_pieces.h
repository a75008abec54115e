// SPDX-License-Identifier: MIT
//
// Numbers among the pieces of a line of a mesh file. Not installed.

#pragma once

#include "internode/io/file/limits.h"
#include "internode/text/lines.h"
#include "internode/text/number.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode {

/// A piece between backquotes, its first 40 bytes, as a terminal may see it.
[[nodiscard]] inline std::string piece_quoted(std::string_view piece) {
    constexpr std::size_t shown = 40;
    return '`' + printable(piece.substr(0, shown)) + (piece.size() > shown ? "...`" : "`");
}

/// The coordinate of a piece; none, and a complaint, where it is not one.
[[nodiscard]] inline std::optional<double> coordinate_of(const LinePiece& piece, TextLines& lines) {
    const std::optional<double> number = parse_double(piece.text);
    if (!number) lines.refuse(piece, piece_quoted(piece.text) + " is not a number within the range of doubles");
    return number;
}

/// The whole number of a piece, 0 or more; none, and a complaint, where it is not one.
[[nodiscard]] inline std::optional<std::uint64_t> count_of(const LinePiece& piece, TextLines& lines) {
    std::uint64_t value = 0;
    const char* const end = piece.text.data() + piece.text.size();
    const auto [stop, error] = std::from_chars(piece.text.data(), end, value);
    if (error == std::errc{} && stop == end) return value;
    lines.refuse(piece, piece_quoted(piece.text) + " is not a whole number");
    return std::nullopt;
}

/// The vertex of that number; one that is too large for any is the largest, and no vertex has that.
[[nodiscard]] inline std::uint32_t vertex_of(std::uint64_t number) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(number, 0xFFFFFFFE));
}

/// "more than 40000000 vertices, the limit".
[[nodiscard]] inline std::string beyond_mesh_limit(std::string_view what) {
    return "more than " + std::to_string(max_mesh_vertices) + ' ' + std::string(what) + ", the limit";
}

/// The pieces of the line at hand, which are several times as large; none, and a complaint, where it is too long.
[[nodiscard]] inline std::vector<LinePiece> pieces_of(TextLines& lines) {
    if (lines.line().size() <= max_mesh_line_bytes) return blank_separated(lines.line());
    lines.refuse_text("line " + std::to_string(lines.number()) + " has more than " +
                      std::to_string(max_mesh_line_bytes) + " bytes, the limit");
    return {};
}

} // namespace internode
