// SPDX-License-Identifier: MIT
//
// Any text as a JSON grid: refused with places, or accepted and then the same after being written and read again.

#include "internode/io/json/grid_json.h"
#include "internode/io/json/input_grid.h"
#include "internode/text/diagnostic.h"
#include "tests/fuzz/require.h"

#include <cstdint>

namespace {

using namespace internode;
using fuzz::require;
using fuzz::same_bits;

/// The letters of a side as a word over an alphabet of their own.
GridSide written(const InputPolygon& side, Word& word) {
    GridSide result;
    for (const PlacedText& letter : side.word_letters.value_or(std::vector<PlacedText>{})) {
        word.push_back(to_symbol(result.symbols.size()));
        result.symbols.push_back(letter.text);
    }
    result.degree = side.degree.value_or(1);
    result.ends = side.closed.value_or(false) ? Ends::Circular : Ends::Open;
    result.word = word;
    return result;
}

void require_same_after_writing(const InputGrid& grid) {
    GridDocument document;
    std::array<Word, 2> words;
    for (std::size_t k = 0; k < 2; ++k) document.sides[k] = written(grid.sides[k], words[k]);
    document.columns = grid.columns;
    document.rational = grid.rational;
    document.points = {grid.dimension, grid.points};
    StringSink sink;
    require(write_grid_json(sink, document));
    const ParsedGrid again = read_grid_json(sink.text(), "again.json");
    require(again.grid && same_bits(again.grid->points, grid.points));
    require(again.grid->rows == grid.rows && again.grid->columns == grid.columns);
    require(again.grid->rational == grid.rational);
    for (std::size_t k = 0; k < 2; ++k) {
        require(again.grid->sides[k].degree == document.sides[k].degree);
        require(again.grid->sides[k].word_letters.value().size() == words[k].size());
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedGrid parsed = read_grid_json(text, "fuzz.json");
    require(parsed.grid.has_value() == parsed.errors.empty());
    if (!parsed.grid) {
        require(!to_string(parsed.errors).empty());
        return 0;
    }
    require(parsed.grid->points.size() == parsed.grid->rows * parsed.grid->columns * parsed.grid->dimension);
    require_same_after_writing(*parsed.grid);
    return 0;
}
