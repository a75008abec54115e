// SPDX-License-Identifier: MIT
//
// One walk over the word with a stack of axes: `[` puts the axis aside, and a strand in the branch begins at its last
// point; `]` returns to it. A ring begins with the last point of its main axis, which a branch before the first point
// hangs on.

#include "internode/point/strands.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace internode {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Where the points of a letter are among its values.
struct PointsOfLetter {
    std::vector<std::size_t> offsets;
    std::vector<std::size_t> extents;
};

std::vector<PointsOfLetter> points_of_letters(const Layout& layout) {
    std::vector<PointsOfLetter> result(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        std::size_t offset = 0;
        for (const Extent extent : layout[i].value_or(std::vector<Extent>())) {
            if (extent > 0) {
                result[i].offsets.push_back(offset);
                result[i].extents.push_back(extent);
            }
            offset += extent == 0 ? 1 : extent;
        }
    }
    return result;
}

class Drawing {
public:
    Drawing(const ModuleWord& word, const PointSystem& system, std::size_t passes)
        : word_(word)
        , ring_(system.grammar().ring)
        , open_(branch_open(system.grammar()))
        , close_(branch_close(system.grammar()))
        , letters_(points_of_letters(system.layout(passes))) {}

    PointStrands make() {
        drawing_.dimension = first_dimension();
        current_.last = ring_ ? last_of_main_axis() : none;
        for (std::size_t i = 0; i < word_.size(); ++i) visit(i);
        while (!stems_.empty()) leave();
        finish(ring_);
        return std::move(drawing_);
    }

private:
    /// One point, or the two ends of a line, of the dimension that is drawn.
    [[nodiscard]] bool is_drawn(const PointsOfLetter& points) const {
        return !points.offsets.empty() && points.offsets.size() <= 2 &&
               std::ranges::all_of(points.extents, [&](std::size_t one) { return one == drawing_.dimension; });
    }

    [[nodiscard]] std::size_t first_dimension() const {
        for (const Symbol letter : word_.letters()) {
            const PointsOfLetter& points = letters_[to_index(letter)];
            if (!points.offsets.empty() && points.offsets.size() <= 2) return points.extents.front();
        }
        return 0;
    }

    /// The strand that is being drawn; it begins in `strands` with its first point.
    struct Axis {
        std::size_t strand = none;
        std::size_t last = none; ///< the last point on the way from the root
    };

    void visit(std::size_t i) {
        if (open_ && word_.letter(i) == *open_)
            enter();
        else if (close_ && word_.letter(i) == *close_ && !stems_.empty())
            leave();
        else
            draw(i);
    }

    void draw(std::size_t i) {
        const PointsOfLetter& points = letters_[to_index(word_.letter(i))];
        if (!is_drawn(points)) return;
        std::vector<double>& target = points.offsets.size() == 1 ? drawing_.points : drawing_.lines;
        for (const std::size_t offset : points.offsets) {
            const std::span<const double> value = word_.values(i).subspan(offset, drawing_.dimension);
            target.insert(target.end(), value.begin(), value.end());
        }
        if (points.offsets.size() == 1) join(drawing_.size() - 1);
    }

    void join(std::size_t point) {
        if (current_.strand == none) {
            current_.strand = drawing_.strands.size();
            drawing_.strands.emplace_back();
            if (!stems_.empty() && current_.last != none) drawing_.strands.back().points.push_back(current_.last);
        }
        assert(current_.strand < drawing_.strands.size() && point < drawing_.size());
        drawing_.strands[current_.strand].points.push_back(point);
        current_.last = point;
    }

    void enter() {
        stems_.push_back(current_);
        current_.strand = none;
    }

    void leave() {
        assert(!stems_.empty());
        current_ = stems_.back();
        stems_.pop_back();
    }

    void finish(bool closed) {
        if (current_.strand != none) drawing_.strands[current_.strand].closed = closed;
    }

    /// The number of the last point outside all branches, where a ring goes on at its beginning.
    [[nodiscard]] std::size_t last_of_main_axis() const {
        std::size_t depth = 0;
        std::size_t count = 0;
        std::size_t last = none;
        for (std::size_t i = 0; i < word_.size(); ++i) {
            if (open_ && word_.letter(i) == *open_) ++depth;
            if (close_ && word_.letter(i) == *close_ && depth > 0) --depth;
            const PointsOfLetter& points = letters_[to_index(word_.letter(i))];
            if (points.offsets.size() != 1 || !is_drawn(points)) continue;
            if (depth == 0) last = count;
            ++count;
        }
        return last;
    }

    const ModuleWord& word_;
    bool ring_;
    std::optional<Symbol> open_;
    std::optional<Symbol> close_;
    std::vector<PointsOfLetter> letters_;
    Axis current_;
    std::vector<Axis> stems_;
    PointStrands drawing_;
};

} // namespace

PointStrands strands(const ModuleWord& word, const PointSystem& system, std::size_t passes) {
    assert(passes <= system.grammar().interpretations.size());
    return Drawing(word, system, passes).make();
}

} // namespace internode
