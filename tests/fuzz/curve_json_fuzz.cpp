// SPDX-License-Identifier: MIT
//
// Any text as a JSON curve: refused with places, or accepted and then the same after being written and read again.

#include "internode/io/json/curve_json.h"
#include "internode/io/polygon.h"
#include "internode/text/diagnostic.h"
#include "tests/fuzz/require.h"

#include <cstdint>

namespace {

using namespace internode;
using fuzz::require;
using fuzz::same_bits;

bool same_coefficients(const InputPolygon& a, const InputPolygon& b) {
    if (a.lengths.size() != b.lengths.size()) return false;
    for (std::size_t i = 0; i < a.lengths.size(); ++i)
        if (a.lengths[i].coefficients != b.lengths[i].coefficients) return false;
    return true;
}

std::vector<CurveLength> written(const std::vector<InputLength>& lengths) {
    std::vector<CurveLength> result;
    for (const InputLength& length : lengths) {
        result.push_back({length.symbol.text, 0, {}});
        for (const Rational& coefficient : length.coefficients) result.back().exact.push_back(to_string(coefficient));
    }
    return result;
}

/// The points as rows with their weights behind them, as they are written.
std::vector<double> weighted_rows(const InputPolygon& polygon) {
    std::vector<double> rows;
    for (std::size_t k = 0; k < polygon.weights.size(); ++k) {
        const auto first = polygon.points.begin() + static_cast<std::ptrdiff_t>(k * polygon.dimension);
        rows.insert(rows.end(), first, first + static_cast<std::ptrdiff_t>(polygon.dimension));
        rows.push_back(polygon.weights[k]);
    }
    return rows;
}

void require_same_after_writing(const InputPolygon& polygon) {
    CurveDocument curve;
    Word word;
    for (const PlacedText& letter : polygon.word_letters.value_or(std::vector<PlacedText>{})) {
        word.push_back(to_symbol(curve.symbols.size()));
        curve.symbols.push_back(letter.text);
    }
    curve.word = word;
    curve.degree = polygon.degree.value_or(1);
    curve.lengths = written(polygon.lengths);
    const std::vector<double> rows = weighted_rows(polygon);
    curve.weighted = !rows.empty();
    curve.points =
        curve.weighted ? PointsView{polygon.dimension + 1, rows} : PointsView{polygon.dimension, polygon.points};
    StringSink sink;
    require(write_curve_json(sink, curve));
    const ParsedPolygon again = read_polygon(sink.text(), "again.json");
    require(again.polygon && same_bits(again.polygon->points, polygon.points));
    require(same_bits(again.polygon->weights, polygon.weights));
    require(again.polygon->degree == curve.degree && same_coefficients(*again.polygon, polygon));
    require(again.polygon->word_letters.value_or(std::vector<PlacedText>{}).size() == word.size());
}

/// An exact number may have more digits, written as a fraction, than a text of ours may have.
bool has_moderate_lengths(const InputPolygon& polygon) {
    for (const InputLength& length : polygon.lengths)
        for (const Rational& coefficient : length.coefficients)
            if (to_string(coefficient).size() > 300) return false;
    return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedPolygon parsed = read_polygon_json(text, "fuzz.json");
    require(parsed.polygon.has_value() == parsed.errors.empty());
    if (!parsed.polygon)
        require(!to_string(parsed.errors).empty());
    else if (has_moderate_lengths(*parsed.polygon))
        require_same_after_writing(*parsed.polygon);
    return 0;
}
