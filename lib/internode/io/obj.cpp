// SPDX-License-Identifier: MIT

#include "internode/io/obj.h"

#include "internode/io/comment_text.h"
#include "internode/io/text_buffer.h"

#include <algorithm>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t indices_a_line = 256;

bool write_vertices(TextBuffer& text, const PointsView& points) {
    for (std::size_t row = 0; row < points.size(); ++row) {
        text << 'v';
        for (const double coordinate : points[row]) text << ' ' << coordinate;
        for (std::size_t i = points.dimension; i < max_obj_dimension; ++i) text << " 0";
        if (!text.end_line()) return false;
    }
    return true;
}

/// The indices 1 … size, then 1 again when circular, in chained lines.
bool write_polyline(TextBuffer& text, std::size_t size, Ends ends) {
    const std::size_t count = size + (ends == Ends::Circular ? 1 : 0);
    for (std::size_t begin = 0; begin + 1 < count; begin += indices_a_line - 1) {
        text << 'l';
        for (std::size_t i = begin; i < std::min(begin + indices_a_line, count); ++i) text << ' ' << i % size + 1;
        if (!text.end_line()) return false;
    }
    return true;
}

} // namespace

bool write_obj(Sink& sink, const PointsView& points, Ends ends, std::span<const std::string> comments) {
    require_whole_rows(points);
    if (points.dimension > max_obj_dimension) throw std::invalid_argument("OBJ has at most 3 dimensions");
    TextBuffer text(sink);
    for (const std::string& comment : comments) {
        text << "# " << comment_text(comment);
        text.end_line();
    }
    if (!write_vertices(text, points)) return false;
    if (points.size() == 1) {
        text << "p 1";
        text.end_line();
    } else if (!write_polyline(text, points.size(), ends)) {
        return false;
    }
    return text.flush();
}

} // namespace internode
