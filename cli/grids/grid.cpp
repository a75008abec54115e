// SPDX-License-Identifier: MIT

#include "cli/grids/grid.h"

#include "cli/shell/load.h"
#include "cli/shell/settled.h"
#include "internode/input/polygon_file.h"
#include "internode/input/settled_grid.h"

namespace internode::cli {
LoadedGrid load_grid(const SubdivideOptions& options) {
    const LoadedText input = load_text(options.polygon.place);
    InputGrid grid = value_of(grid_of_file(input.text, input.source, options.polygon.element));
    const auto& [u, v] = options.sides;
    const std::array<IntervalSystem, 2> systems{load_system({u.grammar, std::nullopt}),
                                                load_system({v.grammar, std::nullopt})};
    const GridOptions said{.sides = {{{u.degree, u.word}, {v.degree, v.word}}}, .repeat = options.polygon.repeat};
    return {value_of(settle_grid(systems, std::move(grid), said)), input.source};
}

} // namespace internode::cli
