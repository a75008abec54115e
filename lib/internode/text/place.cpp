// SPDX-License-Identifier: MIT

#include "internode/text/place.h"

#include "internode/text/limits.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// The line that begins at `begin`, without its end; empty when it is too long to be shown.
std::string shown_line(std::string_view text, std::size_t begin) {
    assert(begin <= text.size());
    const std::string_view cut = text.substr(begin, max_shown_line_bytes + 1);
    std::string_view line = cut.substr(0, cut.find('\n'));
    if (line.size() > max_shown_line_bytes) return {};
    if (line.ends_with('\r')) line.remove_suffix(1);
    return std::string(line);
}

Diagnostic make_diagnostic(TextPlace place, std::string_view source, std::string message, std::string line) {
    assert(place.line >= 1 && place.column >= 1);
    Diagnostic diagnostic;
    diagnostic.source = source;
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    diagnostic.message = std::move(message);
    diagnostic.source_line = std::move(line);
    return diagnostic;
}

} // namespace

TextPlace place_of(std::string_view text, std::size_t offset, std::size_t known_offset, TextPlace known) {
    assert(known_offset <= offset && known_offset <= text.size());
    for (const char c : text.substr(0, offset).substr(known_offset)) {
        if (c == '\n') {
            ++known.line;
            known.column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
            ++known.column;
        }
    }
    return known;
}

TextPlace place_of(std::string_view text, std::size_t offset) {
    return place_of(text, offset, 0, {});
}

std::size_t columns_of(std::string_view piece) {
    return std::max<std::size_t>(place_of(piece, piece.size()).column - 1, 1);
}

Diagnostic diagnostic_at(std::string_view text, std::size_t offset, std::string_view source, std::string message) {
    offset = std::min(offset, text.size());
    const std::size_t newline = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
    return make_diagnostic(place_of(text, offset), source, std::move(message), shown_line(text, begin));
}

Diagnostic diagnostic_at(std::string_view text, TextPlace place, std::string_view source, std::string message) {
    std::size_t begin = 0;
    for (std::size_t line = 1; line < place.line; ++line) {
        const std::size_t newline = text.find('\n', begin);
        if (newline == std::string_view::npos) break;
        begin = newline + 1;
    }
    return make_diagnostic(place, source, std::move(message), shown_line(text, begin));
}

} // namespace internode
