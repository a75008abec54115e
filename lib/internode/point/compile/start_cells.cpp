// SPDX-License-Identifier: MIT
//
// With pieces of W modules to each side 2W + 3 points show every cell: W + 1 at each end, and one in the middle, whose
// cells all others between have.

#include "internode/point/compile/start_cells.h"

#include "internode/point/effective_input.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {
namespace {

/// A module of the start word: its numbers exact, its points new ones.
std::optional<ExactStop> add_opaque(const ModuleTemplate& made, const PointSystem& system, std::ptrdiff_t& next,
                                    ExactWord& word) {
    ExactModule module{made.letter, {}, 0};
    const std::vector<Extent>& extents = system.layout()[to_index(made.letter)].value();
    for (std::size_t i = 0; i < extents.size(); ++i) {
        if (extents[i] > 0) {
            module.values.emplace_back(PointSum{{{next++, Rational(1)}}});
            continue;
        }
        ExactResult result = exact_value(made.arguments[i], {}, system.scope());
        if (!result.value) return ExactStop{made.arguments[i].place, result.reason};
        module.values.emplace_back(std::get<Rational>(*std::move(result.value)));
    }
    word.push_back(std::move(module));
    return std::nullopt;
}

std::size_t cells_of(const std::vector<ModuleTemplate>& part, const Layout& layout) {
    std::size_t cells = 0;
    for (const ModuleTemplate& made : part)
        for (const Extent extent : layout[to_index(made.letter)].value()) cells += extent > 0 ? 1 : 0;
    return cells;
}

} // namespace

std::size_t shown_points(std::size_t points, std::size_t side) {
    return std::min(points, 2 * side + 3);
}

void require_start(const PointSystem& system, StartWord start) {
    if (start.points == std::size_t{0}) throw std::invalid_argument("a polygon without points");
    if (start.points && !effective_input(system.grammar(), system.start()))
        throw std::invalid_argument("a grammar without an input");
    if (!start.points && !system.grammar().axiom) throw std::invalid_argument("a grammar without an axiom");
}

std::variant<ExactWord, ExactStop> shown_word(const PointSystem& system, StartWord start, std::size_t side) {
    require_start(system, start);
    const std::optional<PointInput> input = effective_input(system.grammar(), system.start());
    ExactWord word;
    std::ptrdiff_t next = 0;
    std::optional<ExactStop> stop;
    const auto add = [&](const std::vector<ModuleTemplate>& part) {
        for (const ModuleTemplate& made : part)
            if (!stop) stop = add_opaque(made, system, next, word);
    };
    if (!start.points) {
        add(*system.grammar().axiom);
    } else {
        const std::size_t count = shown_points(*start.points, side);
        for (std::size_t i = 0; i < count; ++i) add(input_part(*input, i, count));
    }
    if (stop) return *std::move(stop);
    return word;
}

CellsOfStart start_cells(const std::vector<std::uint32_t>& shown, const PointSystem& system, StartWord start,
                         std::size_t side) {
    CellsOfStart cells{shown, std::nullopt};
    if (!start.points || *start.points < 2 * side + 3) return cells;
    // Whole points; each of the middle ones has as many cells.
    const PointInput input = effective_input(system.grammar(), system.start()).value();
    const std::size_t inner = cells_of(input.each, system.layout());
    const std::size_t first = cells_of(input.has_ends ? input.first : input.each, system.layout()) + side * inner;
    assert(first + inner <= shown.size());
    const auto middle = shown.begin() + static_cast<std::ptrdiff_t>(first);
    cells.interior = *middle;
    cells.states.assign(shown.begin(), middle);
    for (std::size_t i = shown_points(*start.points, side); i < *start.points; ++i)
        cells.states.insert(cells.states.end(), middle, middle + static_cast<std::ptrdiff_t>(inner));
    cells.states.insert(cells.states.end(), middle, shown.end());
    return cells;
}

} // namespace internode
