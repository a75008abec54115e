// SPDX-License-Identifier: MIT
//
// A control polygon as a file gives it: N points of one dimension, and whatever the file says about degree, ends, word
// and lengths, or knots, and weights. Whether these fit each other and a grammar is for input/ to say.
//
// CSV: a point a line, `,`, `;` or tab between the coordinates (the first line decides), an optional header, `#`
// comments, CR LF, a byte order mark. Empty lines (gnuplot) and lines that begin with `>` (GMT) part polygons; the
// header stands once, or again in each part. JSON: an object of format "internode-curve" (docs/), the bare array of its
// points, or "internode-curves", several of them. Coordinates are finite doubles, correctly rounded; lengths stay
// exact.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/text/diagnostic.h"
#include "internode/text/place.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// A piece of the user's text and where it stands.
struct PlacedText {
    std::string text;
    TextPlace place;
};

/// A number that the file says exactly: Σ coefficients[i] ρ^i, ρ the ratio of the grammar; one for a rational.
using InputNumber = std::vector<Rational>;

/// A length that the file fixes.
struct InputLength {
    PlacedText symbol;
    InputNumber coefficients;
};

struct InputPolygon {
    std::string source;               ///< the file's name, for diagnostics about what stands here
    std::size_t dimension = 0;        ///< 1 … max_dimension
    std::vector<double> points;       ///< N rows of `dimension` coordinates, N >= 1, all finite
    std::vector<std::string> columns; ///< names of the coordinates; empty without a header, and for JSON
    std::optional<std::size_t> degree;
    std::optional<bool> closed;
    std::optional<PlacedText> word_text;                 ///< "word": "SL SL", as --word takes it
    std::optional<std::vector<PlacedText>> word_letters; ///< "word": ["S", "L"]
    std::vector<InputLength> lengths;                    ///< lengths in the order of the file, no symbol twice
    std::optional<std::vector<InputNumber>> knots;       ///< at most max_knots of them
    std::optional<InputNumber> origin;                   ///< the parameter where the domain begins
    std::vector<double> weights;                         ///< one per point, positive; empty when the file has none
    std::size_t line = 0; ///< where the polygon begins in its file; 0 when it is the whole file
    std::string
        break_text; ///< the lines of a CSV that part it from what stands before, blank or `> …`, each with its end

    [[nodiscard]] std::size_t size() const { return points.size() / dimension; }
};

struct ParsedPolygon {
    std::optional<InputPolygon> polygon; ///< present iff errors is empty
    std::vector<Diagnostic> errors;      ///< errors in the order of the text, at most max_polygon_errors
};

struct ParsedPolygons {
    std::vector<InputPolygon> polygons; ///< at least one iff errors is empty; all of one dimension in a CSV
    std::vector<Diagnostic> errors;     ///< errors in the order of the text, at most max_polygon_errors
};

/// Both never throw on any text (but std::bad_alloc). Cost: linear in the text.
/// `threads` read long runs of points, 0: as many as the machine has; the result is the same.
[[nodiscard]] ParsedPolygons read_polygons_csv(std::string_view text, std::string_view source, int threads = 1);
[[nodiscard]] ParsedPolygons read_polygons_json(std::string_view text, std::string_view source);

/// One of the two by the first character that is not blank: `{` or `[` begins JSON.
[[nodiscard]] ParsedPolygons read_polygons(std::string_view text, std::string_view source, int threads = 1);

/// The same where one polygon is meant: a second one is an error at its place.
[[nodiscard]] ParsedPolygon read_polygon_csv(std::string_view text, std::string_view source);
[[nodiscard]] ParsedPolygon read_polygon_json(std::string_view text, std::string_view source);
[[nodiscard]] ParsedPolygon read_polygon(std::string_view text, std::string_view source);

} // namespace internode
