// SPDX-License-Identifier: MIT
//
// Any text as a CSV polygon: refused with places, or accepted and then the same after being written and read again.

#include "internode/io/csv.h"
#include "internode/io/polygon.h"
#include "internode/text/diagnostic.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <cstdint>

using internode::fuzz::require;
using internode::fuzz::same_bits;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace internode;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedPolygon parsed = read_polygon_csv(text, "fuzz.csv");
    require(parsed.polygon.has_value() == parsed.errors.empty());
    if (!parsed.polygon) {
        require(!to_string(parsed.errors).empty());
        return 0;
    }
    const InputPolygon& polygon = *parsed.polygon;
    require(polygon.dimension >= 1 && polygon.size() >= 1 && polygon.points.size() % polygon.dimension == 0);
    for (const double coordinate : polygon.points) require(std::isfinite(coordinate));
    StringSink sink;
    require(write_csv(sink, {polygon.dimension, polygon.points}));
    const ParsedPolygon again = read_polygon_csv(sink.text(), "again.csv");
    require(again.polygon && same_bits(again.polygon->points, polygon.points));
    return 0;
}
