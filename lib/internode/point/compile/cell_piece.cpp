// SPDX-License-Identifier: MIT
//
// A piece goes through the steps of a cycle as a word (Moving) that loses at its sides what is not settled, while the
// cell's own modules are followed. Then the children's pieces are cut out of it. Where it has become too short for one,
// W is too small.

#include "internode/point/compile/cell_piece.h"
#include "internode/stencil/kernel.h"

#include <algorithm>
#include <cassert>

namespace internode {
namespace {

/// A word of a piece, on its way through the steps of a cycle.
struct Moving {
    ExactWord word;
    std::vector<std::size_t> starts;
    PieceSides sides;
    OwnModules own;
};

bool starts_at(const std::vector<std::size_t>& starts, std::size_t i) {
    return std::ranges::find(starts, i) != starts.end();
}

CellRow row_of(const PointSum& sum) {
    CellRow row;
    if (sum.terms.empty()) return row;
    assert(std::ranges::is_sorted(sum.terms, {}, [](const auto& term) { return term.first; }));
    row.first = sum.terms.front().first;
    row.weights.resize(static_cast<std::size_t>(sum.terms.back().first - row.first) + 1);
    for (const auto& term : sum.terms) row.weights[static_cast<std::size_t>(term.first - row.first)] = term.second;
    return row;
}

/// The word of a piece, its points numbered from the cell.
Moving moving(const CellPiece& piece, const KindTable& kinds, OwnModules own) {
    assert(piece.center < piece.kinds.size());
    std::ptrdiff_t next = -static_cast<std::ptrdiff_t>(piece.slot);
    for (std::size_t i = 0; i < piece.center; ++i)
        next -= static_cast<std::ptrdiff_t>(kinds.point_count(piece.kinds[i]));
    Moving moving{{}, {piece.starts.begin(), piece.starts.end()}, {piece.left_open, piece.right_open}, own};
    for (const std::uint32_t kind : piece.kinds) moving.word.push_back(kinds.module(kind, next));
    return moving;
}

/// Where the successors of module i begin, when those of the settled modules first, first + 1, … stand in the word.
std::size_t place_after(const ExactWord& word, std::size_t i) {
    const auto place = std::ranges::find_if(word, [i](const ExactModule& module) { return module.parent >= i; });
    return static_cast<std::size_t>(place - word.begin());
}

/// One step. False: not settled, or a stop.
bool advance(Moving& moving, const PointSystem& system, std::optional<std::uint32_t> table, ExactBudget& budget,
             std::optional<ExactStop>& stop) {
    PieceStep step =
        exact_piece_step(system, moving.word, moving.sides, moving.own.first, moving.own.last, table, budget);
    stop = std::move(step.stop);
    if (!step.word) return false;
    std::vector<std::size_t> starts;
    for (const std::size_t start : moving.starts)
        if (start >= step.first && start <= step.last) starts.push_back(place_after(*step.word, start));
    moving.own = {place_after(*step.word, moving.own.first), place_after(*step.word, moving.own.last)};
    moving.starts = std::move(starts);
    moving.sides = step.sides;
    moving.word = *std::move(step.word);
    return true;
}

/// Whether a new point of the cell depends on more consecutive ones than a kernel takes.
bool is_too_wide(const Moving& moving) {
    for (std::size_t m = moving.own.first; m < moving.own.last; ++m)
        for (const ExactValue& value : moving.word[m].values) {
            const PointSum* const sum = std::get_if<PointSum>(&value);
            if (sum == nullptr || sum->terms.empty()) continue;
            const std::ptrdiff_t width = sum->terms.back().first - sum->terms.front().first + 1;
            if (width > static_cast<std::ptrdiff_t>(max_row_width)) return true;
        }
    return false;
}

/// Cuts the pieces of the children out of what a piece has become.
class Cutter {
public:
    Cutter(const Moving& moving, KindTable& kinds, std::size_t side)
        : moving_(moving)
        , kinds_(kinds)
        , side_(side) {}

    /// The children, or nothing when the word is too short for one of them.
    std::optional<std::vector<PieceChild>> children() {
        std::vector<PieceChild> children;
        for (std::size_t m = moving_.own.first; m < moving_.own.last; ++m)
            for (std::size_t slot = 0; slot < points_in(moving_.word[m]); ++slot) {
                std::optional<PieceChild> child = cut(m, slot);
                if (!child) return std::nullopt;
                children.push_back(*std::move(child));
            }
        return children;
    }

private:
    /// The first module of the word that tells which modules cell m owns: the start of the word where no point stands
    /// between, else m itself. None where it lies before the word.
    [[nodiscard]] std::optional<std::size_t> first_told(std::size_t m) const {
        assert(m < moving_.word.size());
        for (std::size_t i = m;; --i) {
            if (starts_at(moving_.starts, i)) return i;
            if (i == 0) return std::nullopt;
            if (points_in(moving_.word[i - 1]) > 0) return m;
        }
    }

    /// The child of a point of module m; none where the word is too short for its piece.
    std::optional<PieceChild> cut(std::size_t m, std::size_t slot) {
        const std::size_t size = moving_.word.size();
        const bool misses_left = m < side_ && moving_.sides.left_open;
        const bool misses_right = m + side_ >= size && moving_.sides.right_open;
        const std::size_t begin = m > side_ ? m - side_ : 0;
        const std::optional<std::size_t> told = first_told(m);
        if (misses_left || misses_right || !told || *told < begin) return std::nullopt;
        const std::size_t end = std::min(size, m + side_ + 1);
        PieceChild child{piece(begin, m, end), -static_cast<std::ptrdiff_t>(slot), {}};
        child.piece.slot = static_cast<std::uint32_t>(slot);
        for (std::size_t i = begin; i < end; ++i) {
            if (i < m) child.first -= static_cast<std::ptrdiff_t>(points_in(moving_.word[i]));
            for (const ExactValue& value : moving_.word[i].values)
                if (const PointSum* sum = std::get_if<PointSum>(&value)) child.rows.push_back(row_of(*sum));
        }
        return child;
    }

    /// Modules begin … end - 1 of the word round module m.
    [[nodiscard]] CellPiece piece(std::size_t begin, std::size_t m, std::size_t end) {
        assert(begin <= m && m < end && end <= moving_.word.size());
        CellPiece piece;
        piece.left_open = moving_.sides.left_open || begin > 0;
        piece.right_open = moving_.sides.right_open || end < moving_.word.size();
        piece.center = static_cast<std::uint32_t>(m - begin);
        for (const std::size_t at : moving_.starts)
            if (at >= begin && at <= end) piece.starts.push_back(static_cast<std::uint32_t>(at - begin));
        for (std::size_t i = begin; i < end; ++i) piece.kinds.push_back(kinds_.of(moving_.word[i]));
        return piece;
    }

    const Moving& moving_;
    KindTable& kinds_;
    std::size_t side_;
};

} // namespace

ExactStop too_wide() {
    return {{}, "needs more than " + std::to_string(max_row_width) + " neighbouring points for a new one"};
}

std::optional<OwnModules> own_modules(const CellPiece& piece, const KindTable& kinds) {
    const auto starts = [&](std::size_t i) {
        return std::ranges::find(piece.starts, static_cast<std::uint32_t>(i)) != piece.starts.end();
    };
    const auto has_points = [&](std::size_t i) { return kinds.point_count(piece.kinds[i]) > 0; };
    OwnModules own{piece.center, piece.center + std::size_t{1}};
    while (own.last < piece.kinds.size() && !has_points(own.last) && !starts(own.last)) ++own.last;
    if (own.last == piece.kinds.size() && piece.right_open && !starts(own.last)) return std::nullopt;
    std::size_t first = piece.center;
    while (!starts(first)) {
        if (first == 0) return piece.left_open ? std::nullopt : std::optional(own);
        if (has_points(--first)) return own;
    }
    own.first = first;
    return own;
}

PieceChildren children_of(const CellPiece& piece, const PointSystem& system, KindTable& kinds, std::size_t side,
                          ExactBudget& budget) {
    if (piece.slot > 0) return {std::vector<PieceChild>(), std::nullopt};
    const std::optional<OwnModules> own = own_modules(piece, kinds);
    if (!own) return {};
    Moving word = moving(piece, kinds, *own);
    for (const std::optional<std::uint32_t> table : system.cycle()) {
        std::optional<ExactStop> stop;
        if (!advance(word, system, table, budget, stop)) return {std::nullopt, std::move(stop)};
        if (word.own.first == word.own.last) return {std::vector<PieceChild>(), std::nullopt};
    }
    if (is_too_wide(word)) return {std::nullopt, too_wide()};
    return {Cutter(word, kinds, side).children(), std::nullopt};
}

CellPiece piece_of_word(const ExactWord& word, bool ring, std::size_t module, std::uint32_t slot, std::size_t side,
                        KindTable& kinds) {
    const std::size_t n = word.size();
    assert(module < n && slot < points_in(word[module]));
    const std::size_t before = ring ? side : std::min(side, module);
    const std::size_t after = ring ? side : std::min(side, n - 1 - module);
    CellPiece piece;
    piece.center = static_cast<std::uint32_t>(before);
    piece.slot = slot;
    piece.left_open = ring || module > side;
    piece.right_open = ring || module + side + 1 < n;
    for (std::size_t i = 0; i <= before + after; ++i) {
        // module + side n is the same place of a ring, and nothing before it is negative.
        const std::size_t at = (module + side * n + i - before) % n;
        if (at == 0) piece.starts.push_back(static_cast<std::uint32_t>(i));
        piece.kinds.push_back(kinds.of(word[at]));
    }
    if (ring && (module + after + 1) % n == 0) piece.starts.push_back(static_cast<std::uint32_t>(piece.kinds.size()));
    return piece;
}

} // namespace internode
