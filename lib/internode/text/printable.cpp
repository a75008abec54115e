// SPDX-License-Identifier: MIT
//
// Characters are told apart by tables of ranges: those that command a terminal or hide in it are escaped, and columns
// are counted as a terminal gives them.

#include "internode/text/printable.h"

#include <algorithm>
#include <array>
#include <cassert>

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

} // namespace

Shown show(std::string_view text, std::size_t place, const CodePoint& point) {
    assert(place < text.size() && point.bytes <= text.size() - place);
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

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t place = 0; place < text.size();) {
        const CodePoint point = code_point_at(text, place);
        result += show(text, place, point).text;
        place += point.bytes;
    }
    return result;
}

} // namespace internode
