// SPDX-License-Identifier: MIT

#include "cli/shell/parts.h"

#include "cli/requests/exit_code.h"

#include <fmt/format.h>

namespace internode::cli {

bool PartSink::write(std::string_view bytes) {
    if (!in_first_line_) return sink_.write(bytes);
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) return !is_first_ || sink_.write(bytes);
    in_first_line_ = false;
    if (is_first_ && !sink_.write(bytes.substr(0, end + 1))) return false;
    if (!break_text_.empty() && !sink_.write(break_text_)) return false;
    return sink_.write(bytes.substr(end + 1));
}

std::string written_break(const std::string& break_text, bool is_first) {
    return break_text.empty() && !is_first ? std::string("\n") : break_text;
}

void refuse_several(std::size_t count, const std::string& output) {
    if (count > 1)
        throw failure(ExitCode::Refused, fmt::format("{} holds one polygon, the file has {}", output, count),
                      fmt::format("CSV, JSON, OBJ and SVG hold all of them; --element 1 … {} takes one", count));
}

void require_equal_columns(std::size_t first, std::size_t other) {
    if (first != other)
        throw failure(
            ExitCode::Refused,
            fmt::format("one polygon has {} columns, another {}: a CSV has as many in every line", first, other),
            "JSON and OBJ hold polygons of any kinds");
}

void require_one_plane(std::size_t first_dimension, std::size_t other_dimension) {
    if ((first_dimension == 1) != (other_dimension == 1))
        throw failure(ExitCode::Refused, "polygons of one coordinate and of more have no picture together",
                      "--element takes one of them");
}

} // namespace internode::cli
