// SPDX-License-Identifier: MIT

#include "internode/io/obj/obj.h"

#include "internode/io/file/comment_text.h"
#include "internode/io/file/text_buffer.h"
#include "internode/io/file/text_lines.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>
#include <utility>

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

/// The chained lines of a polyline of `size` points, its first again when closed; `at(i)` is index number i, from 0.
template<typename Index>
class Chain {
public:
    Chain(std::size_t size, bool closed, Index at)
        : size_(size)
        , count_(size + (closed ? 1 : 0))
        , at_(std::move(at)) {}

    [[nodiscard]] std::size_t lines() const {
        if (size_ == 1) return 1;
        return count_ < 2 ? 0 : (count_ - 2) / (indices_a_line - 1) + 1;
    }

    void append_line(std::size_t line, std::string& text) const {
        assert(line < lines());
        text += size_ == 1 ? 'p' : 'l';
        const std::size_t begin = line * (indices_a_line - 1);
        const std::size_t end = size_ == 1 ? 1 : std::min(begin + indices_a_line, count_);
        for (std::size_t i = begin; i < end; ++i) text += ' ' + std::to_string(at_(i % size_) + 1);
        text += '\n';
    }

private:
    std::size_t size_;
    std::size_t count_; ///< indices in all
    Index at_;
};

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
    const Chain chain(points.size(), ends == Ends::Circular, [before](std::size_t i) { return before + i; });
    const auto put_line = [&](std::size_t line, std::string& text) { chain.append_line(line, text); };
    return write_lines(sink, chain.lines(), threads, put_line);
}

bool write_obj(Sink& sink, const PointsView& points, std::span<const ObjPolyline> polylines,
               std::span<const std::string> comments, std::size_t before, int threads) {
    for (const ObjPolyline& polyline : polylines)
        for (const std::size_t index : polyline.points)
            if (index >= points.size()) throw std::out_of_range("OBJ: no such point");
    if (!write_points(sink, points, comments, threads)) return false;
    // One line or so each, of some thousand polylines: not worth a thread.
    TextBuffer text(sink);
    for (const ObjPolyline& polyline : polylines) {
        const Chain chain(polyline.points.size(), polyline.closed,
                          [&](std::size_t i) { return before + polyline.points[i]; });
        for (std::size_t line = 0; line < chain.lines(); ++line) {
            std::string indices;
            chain.append_line(line, indices);
            text << indices;
            if (!text.pass_on()) return false;
        }
    }
    return text.flush();
}

} // namespace internode
