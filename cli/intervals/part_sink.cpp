// SPDX-License-Identifier: MIT

#include "cli/intervals/part_sink.h"

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

} // namespace internode::cli
