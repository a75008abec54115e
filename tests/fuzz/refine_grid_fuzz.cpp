// SPDX-License-Identifier: MIT
//
// Any bytes as the file of a grid, to the refined grid: refused with a sentence, or refined to as many points as the
// words ask for. The knots keep their origins.

#include "internode/input/polygon_file.h"
#include "internode/input/settled_grid.h"
#include "internode/surface/refinement.h"
#include "tests/fuzz/small_inputs.h"

namespace {

using namespace internode;
using fuzz::require;

bool is_small(const InputGrid& grid) {
    return grid.points.size() <= 200 && fuzz::is_small(grid.sides[0]) && fuzz::is_small(grid.sides[1]);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Chosen chosen = fuzz::chosen(data, size);
    const Settled<InputGrid> read = grid_of_file(chosen.text, "fuzz.json");
    require(read.value.has_value() == read.refusal.errors.empty());
    if (!read.value || !is_small(*read.value)) return 0;
    const GridOptions options{.sides = {}, .repeat = (chosen.choice & 8U) != 0};
    const Settled<Grid> grid =
        settle_grid({fuzz::system_of(chosen.choice), fuzz::system_of(chosen.choice / 4)}, *read.value, options);
    require(grid.value.has_value() == grid.refusal.errors.empty());
    if (!grid.value) {
        require(!to_string(grid.refusal.errors).empty());
        return 0;
    }
    const Grid fine = refine(*grid.value, 1, 1, {});
    require(fine.points().size() == fine.u().size() * fine.v().size() * fine.dimension());
    require(fine.u().origin() == grid.value->u().origin() && fine.v().origin() == grid.value->v().origin());
    return 0;
}
