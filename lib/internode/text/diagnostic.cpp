// SPDX-License-Identifier: MIT
//
// A source line is shown with the offence in it. It is cut before and after the caret, in columns as a terminal counts
// them, so that both the caret and what stands round it fit a line of the screen.

#include "internode/text/diagnostic.h"

#include "internode/text/printable.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

/// Columns of a line on the screen, and those of them before the caret: a line is cut so that both fit.
constexpr std::size_t line_columns = 100;
constexpr std::size_t lead_columns = 60;

/// The code points of the line before the caret that fit into lead_columns: how many bytes to leave out.
std::size_t bytes_cut(std::string_view line, std::size_t caret_byte) {
    assert(caret_byte <= line.size());
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
    assert(diagnostic.source_column >= 1);
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

} // namespace

std::string to_string(const Diagnostic& diagnostic) {
    std::string result = printable(diagnostic.source);
    if (diagnostic.line > 0) result += fmt::format(":{}", diagnostic.line);
    if (diagnostic.line > 0 && diagnostic.column > 0) result += fmt::format(":{}", diagnostic.column);
    if (!result.empty()) result += ": ";
    result += fmt::format("error: {}\n", printable(diagnostic.message));
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

} // namespace internode
