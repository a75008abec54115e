// SPDX-License-Identifier: MIT

#include "internode/io/file/comment_text.h"

#include "internode/text/utf8.h"

namespace internode {

namespace {

bool is_shown(const CodePoint& point) {
    const bool ascii = point.value >= 0x20 && point.value < 0x7F;
    const bool beyond_latin_controls = point.value >= 0xA0;
    const bool bidirectional = point.value >= 0x2000 && point.value < 0x2070;
    const bool format = point.value == 0xAD || point.value == 0x061C || point.value == 0xFEFF ||
                        (point.value >= 0xFFF9 && point.value <= 0xFFFB);
    return point.valid && (ascii || (beyond_latin_controls && !bidirectional && !format));
}

} // namespace

std::string comment_text(std::string_view text) {
    constexpr std::size_t max_bytes = 900;
    std::string shown;
    for (std::size_t place = 0; place < text.size() && shown.size() < max_bytes;) {
        const CodePoint point = code_point_at(text, place);
        shown += is_shown(point) ? text.substr(place, point.bytes) : "?";
        place += point.bytes;
    }
    return shown;
}

} // namespace internode
