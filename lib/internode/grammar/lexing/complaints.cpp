// SPDX-License-Identifier: MIT
//
// Complaints are kept in the order of arrival and sorted by place at the end; when twice as many are there as may be
// kept, the later half goes. Columns are counted in one pass, because the places ascend.

#include "internode/grammar/lexing/complaints.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include <fmt/format.h>

namespace internode {

namespace {

std::vector<std::size_t> find_line_starts(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool half_of_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (text[i] == '\n' || (text[i] == '\r' && !half_of_crlf)) starts.push_back(i + 1);
    }
    return starts;
}

/// Bytes of a long line kept on each side of the offence: more than a screen shows.
constexpr std::size_t kept_bytes = 400;

constexpr std::size_t quoted_code_points = 40;

bool is_inside_sequence(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

} // namespace

Complaints::Complaints(std::string_view text, std::string_view source)
    : text_(text)
    , source_(source) {}

void Complaints::add(std::string_view code, Place place, std::string message, std::string hint) {
    assert(place.offset <= text_.size());
    noted_.push_back({code, place, added_++, std::move(message), std::move(hint)});
    if (noted_.size() >= 2 * max_kept_errors + 2) keep_the_first();
}

void Complaints::keep_the_first() {
    const auto before = [](const Note& a, const Note& b) {
        return std::tie(a.place.offset, a.order) < std::tie(b.place.offset, b.order);
    };
    std::ranges::sort(noted_, before);
    if (noted_.size() > max_kept_errors + 1) noted_.erase(noted_.begin() + max_kept_errors + 1, noted_.end());
}

std::size_t Complaints::line_of(std::size_t offset) const {
    if (line_starts_.empty()) line_starts_ = find_line_starts(text_);
    assert(offset <= text_.size());
    const auto after = std::ranges::upper_bound(line_starts_, offset);
    return static_cast<std::size_t>(after - line_starts_.begin());
}

Diagnostic Complaints::locate(const Note& note, std::size_t line, std::size_t column) const {
    assert(line >= 1 && line <= line_starts_.size() && column >= 1);
    const std::size_t start = line_starts_[line - 1];
    std::size_t end = line < line_starts_.size() ? line_starts_[line] : text_.size();
    while (end > start && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    std::size_t first = start;
    const std::size_t offset = note.place.offset;
    if (end - start > 2 * kept_bytes) {
        if (offset - start > kept_bytes) first = offset - kept_bytes;
        while (first < offset && is_inside_sequence(text_[first])) ++first;
        end = std::min(end, offset + kept_bytes);
        while (end > offset && end < text_.size() && is_inside_sequence(text_[end])) --end;
    }
    Diagnostic result;
    result.source = source_;
    result.line = line;
    result.column = column;
    const std::size_t marked = std::min(note.place.bytes, end > offset ? end - offset : 0);
    result.width = std::max<std::size_t>(1, count_code_points(text_.substr(offset, marked)));
    result.code = note.code;
    result.message = note.message;
    result.hint = note.hint;
    result.source_line = text_.substr(first, end - first);
    result.source_column = column - count_code_points(text_.substr(first, offset - first));
    return result;
}

std::vector<Diagnostic> Complaints::diagnostics() && {
    keep_the_first();
    std::vector<Diagnostic> result;
    std::size_t line = 0;
    std::size_t counted = 0; // bytes of the text before this place are counted in column
    std::size_t column = 1;
    for (Note& note : noted_) {
        const std::size_t here = line_of(note.place.offset);
        if (here != line) {
            line = here;
            counted = line_starts_[line - 1];
            column = 1;
        }
        assert(counted <= note.place.offset);
        column += count_code_points(text_.substr(counted, note.place.offset - counted));
        counted = note.place.offset;
        if (result.size() == max_kept_errors) {
            note.code = "text.too-many-errors";
            note.message = fmt::format("more than {} errors; the rest of the text is not judged", max_kept_errors);
            note.hint.clear();
        }
        result.push_back(locate(note, line, column));
    }
    return result;
}

std::string quoted(std::string_view fragment) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < quoted_code_points && place < fragment.size(); ++i)
        place += code_point_at(fragment, place).bytes;
    return fmt::format("`{}{}`", fragment.substr(0, place), place < fragment.size() ? "..." : "");
}

Complaints::Place place_of(const Token& token) {
    return {token.begin, token.bytes};
}

Complaints::Place place_of(std::span<const Token> tokens) {
    assert(!tokens.empty());
    const Token& last = tokens.back();
    return {tokens.front().begin, last.begin + std::size_t{last.bytes} - tokens.front().begin};
}

} // namespace internode
