// SPDX-License-Identifier: MIT

#include "internode/io/obj/obj.h"

#include "internode/io/file/comment_text.h"
#include "internode/io/file/text_buffer.h"
#include "internode/io/file/text_lines.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t indices_a_line = 256;

bool write_vertices(Sink& sink, const PointsView& points, int threads) {
    assert(points.dimension <= max_obj_dimension);
    return write_lines(sink, points.size(), threads, [&](std::size_t row, std::string& text) {
        text += 'v';
        for (const double coordinate : points[row]) {
            text += ' ';
            append(text, coordinate);
        }
        for (std::size_t i = points.dimension; i < max_obj_dimension; ++i) text += " 0";
        text += '\n';
    });
}

/// The indices of a polyline, its first again when closed, in chained lines; `at(i)` is index number i, from 0.
template<typename Index>
bool write_polyline(TextBuffer& text, std::size_t size, bool closed, const Index& at) {
    if (size == 1) {
        text << "p " << at(0) + 1;
        return text.end_line();
    }
    const std::size_t count = size + (closed ? 1 : 0);
    for (std::size_t begin = 0; begin + 1 < count; begin += indices_a_line - 1) {
        text << 'l';
        for (std::size_t i = begin; i < std::min(begin + indices_a_line, count); ++i) text << ' ' << at(i % size) + 1;
        if (!text.end_line()) return false;
    }
    return true;
}

bool write_points(Sink& sink, const PointsView& points, std::span<const std::string> comments, int threads) {
    require_whole_rows(points);
    if (points.dimension > max_obj_dimension) throw std::invalid_argument("OBJ has at most 3 dimensions");
    std::string head;
    for (const std::string& comment : comments) head += "# " + comment_text(comment) + '\n';
    return sink.write(head) && write_vertices(sink, points, threads);
}

} // namespace

bool write_obj(Sink& sink, const PointsView& points, Ends ends, std::span<const std::string> comments,
               std::size_t before, int threads) {
    if (!write_points(sink, points, comments, threads)) return false;
    TextBuffer text(sink);
    const auto row = [before](std::size_t i) { return before + i; };
    return write_polyline(text, points.size(), ends == Ends::Circular, row) && text.flush();
}

bool write_obj(Sink& sink, const PointsView& points, std::span<const ObjPolyline> polylines,
               std::span<const std::string> comments, std::size_t before, int threads) {
    for (const ObjPolyline& polyline : polylines)
        for (const std::size_t index : polyline.points)
            if (index >= points.size()) throw std::out_of_range("OBJ: no such point");
    if (!write_points(sink, points, comments, threads)) return false;
    TextBuffer text(sink);
    for (const ObjPolyline& polyline : polylines) {
        const auto row = [&](std::size_t i) { return before + polyline.points[i]; };
        if (!write_polyline(text, polyline.points.size(), polyline.closed, row)) return false;
    }
    return text.flush();
}

} // namespace internode
