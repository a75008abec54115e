// SPDX-License-Identifier: MIT

#include "internode/text/diagnostic.h"

#include "internode/text/utf8.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

namespace internode {

namespace {

struct Range {
    char32_t first;
    char32_t last;
};

template<std::size_t Size>
bool is_in(const std::array<Range, Size>& ranges, char32_t value) {
    return std::ranges::any_of(ranges, [value](Range range) { return range.first <= value && value <= range.last; });
}

/// Characters that command a terminal or hide: C0, C1, soft hyphen, bidirectional marks and overrides, line and
/// paragraph separators, invisible operators, byte order mark, interlinear marks, tags.
constexpr std::array<Range, 11> hidden{{{0x00, 0x1F},
                                        {0x7F, 0x9F},
                                        {0xAD, 0xAD},
                                        {0x61C, 0x61C},
                                        {0x200B, 0x200F},
                                        {0x2028, 0x202E},
                                        {0x2060, 0x206F},
                                        {0xFEFF, 0xFEFF},
                                        {0xFFF9, 0xFFFB},
                                        {0xE000, 0xF8FF},
                                        {0xE0000, 0x10FFFF}}};

/// Characters two columns wide on a terminal (East Asian wide and full-width forms, pictographs).
constexpr std::array<Range, 13> wide{{{0x1100, 0x115F},
                                      {0x2E80, 0x303E},
                                      {0x3041, 0x33FF},
                                      {0x3400, 0x4DBF},
                                      {0x4E00, 0x9FFF},
                                      {0xA000, 0xA4CF},
                                      {0xAC00, 0xD7A3},
                                      {0xF900, 0xFAFF},
                                      {0xFE30, 0xFE6F},
                                      {0xFF00, 0xFF60},
                                      {0xFFE0, 0xFFE6},
                                      {0x1F300, 0x1FAFF},
                                      {0x20000, 0x3FFFD}}};

/// Marks that take no column of their own.
constexpr std::array<Range, 5> combining{
    {{0x300, 0x36F}, {0x1AB0, 0x1AFF}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}}};

/// A code point as shown, and the columns that it takes.
struct Shown {
    std::string text;
    std::size_t columns = 1;
};

Shown show(std::string_view text, std::size_t place, const CodePoint& point) {
    if (!point.valid) return {fmt::format("\\x{:02X}", static_cast<unsigned>(point.value)), 4};
    if (point.value == '\t') return {"    ", 4};
    if (is_in(hidden, point.value)) {
        std::string escaped = fmt::format("\\u{{{:x}}}", static_cast<unsigned>(point.value));
        const std::size_t columns = escaped.size();
        return {std::move(escaped), columns};
    }
    const std::size_t columns = is_in(combining, point.value) ? 0 : is_in(wide, point.value) ? 2 : 1;
    return {std::string(text.substr(place, point.bytes)), columns};
}

/// Columns of a line on the screen, and those of them before the caret: a line is cut so that both fit.
constexpr std::size_t line_columns = 100;
constexpr std::size_t lead_columns = 60;

/// The code points of the line before the caret that fit into lead_columns: how many bytes to leave out.
std::size_t bytes_cut(std::string_view line, std::size_t caret_byte) {
    std::vector<std::pair<std::size_t, std::size_t>> places; // byte, columns
    std::size_t columns = 0;
    for (std::size_t place = 0; place < caret_byte;) {
        const CodePoint point = code_point_at(line, place);
        places.emplace_back(place, show(line, place, point).columns);
        columns += places.back().second;
        place += point.bytes;
    }
    std::size_t cut = 0;
    for (const auto& [place, width] : places) {
        if (columns <= lead_columns) break;
        columns -= width;
        cut = place + code_point_at(line, place).bytes;
    }
    return cut;
}

/// The byte of the code point number `index`, from 0; the size of the line past its end.
std::size_t byte_of(std::string_view line, std::size_t index) {
    std::size_t place = 0;
    for (; index > 0 && place < line.size(); --index) place += code_point_at(line, place).bytes;
    return place;
}

constexpr std::string_view indent = "    ";
constexpr std::string_view ellipsis = "...";

std::string excerpt(const Diagnostic& diagnostic) {
    const std::string_view line = diagnostic.source_line;
    const bool has_caret = diagnostic.column >= diagnostic.source_column;
    const std::size_t caret_index = has_caret ? diagnostic.column - diagnostic.source_column : 0;
    const std::size_t caret_byte = byte_of(line, caret_index);
    const std::size_t caret_end =
        caret_byte + byte_of(line.substr(caret_byte), std::max<std::size_t>(diagnostic.width, 1));
    const std::size_t start = bytes_cut(line, caret_byte);
    std::string shown(indent);
    std::string carets(indent);
    if (start > 0 || diagnostic.source_column > 1) {
        shown += ellipsis;
        carets += "   ";
    }
    std::size_t columns = 0;
    for (std::size_t place = start; place < line.size();) {
        const CodePoint point = code_point_at(line, place);
        const Shown next = show(line, place, point);
        if (columns + next.columns > line_columns) {
            shown += ellipsis;
            break;
        }
        shown += next.text;
        columns += next.columns;
        if (place < caret_end) carets.append(next.columns, place < caret_byte ? ' ' : '^');
        place += point.bytes;
    }
    if (caret_byte >= line.size()) carets += '^';
    return has_caret ? fmt::format("{}\n{}\n", shown, carets) : shown + '\n';
}

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

/// The optimal string alignment distance, or limit + 1 as soon as it must exceed the limit.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > limit) return limit + 1;
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        if (std::ranges::min(row) > limit) return limit + 1;
        before.swap(last);
        last.swap(row);
    }
    return last.back();
}

} // namespace

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t place = 0; place < text.size();) {
        const CodePoint point = code_point_at(text, place);
        result += show(text, place, point).text;
        place += point.bytes;
    }
    return result;
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string result = printable(diagnostic.source);
    if (diagnostic.line > 0) result += fmt::format(":{}", diagnostic.line);
    if (diagnostic.line > 0 && diagnostic.column > 0) result += fmt::format(":{}", diagnostic.column);
    result += fmt::format(": error: {}\n", printable(diagnostic.message));
    if (!diagnostic.source_line.empty()) result += excerpt(diagnostic);
    if (!diagnostic.hint.empty()) result += fmt::format("hint: {}\n", printable(diagnostic.hint));
    return result;
}

std::string to_string(const std::vector<Diagnostic>& diagnostics) {
    std::string result;
    const std::size_t shown = std::min(diagnostics.size(), shown_errors);
    for (std::size_t i = 0; i < shown; ++i) result += to_string(diagnostics[i]);
    const std::size_t more = diagnostics.size() - shown;
    if (more > 0) result += fmt::format("and {} more error{}\n", more, more == 1 ? "" : "s");
    return result;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const auto alike = [word](const std::string& candidate) { return same_but_for_case(word, candidate); };
    if (const auto found = std::ranges::find_if(candidates, alike); found != candidates.end()) return *found;
    std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate, limit);
        if (distance > limit || distance >= std::max(word.size(), candidate.size())) continue;
        nearest = candidate;
        if (distance == 0) break;
        limit = distance - 1;
        if (limit == 0) break;
    }
    return nearest;
}

} // namespace internode
