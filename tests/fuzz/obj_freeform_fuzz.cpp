// SPDX-License-Identifier: MIT
//
// Any text as OBJ: refused with places, or elements whose indices and counts hold, whose curves get a word or an
// answer.

#include "internode/curve/knot_vector.h"
#include "internode/curve/knots.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"
#include "internode/io/obj/free_form_input.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <cstdint>

namespace {

using namespace internode;
using fuzz::require;

const IntervalSystem& halving() {
    static const IntervalSystem system = *validate(*parse_grammar("A -> A A", "halving").grammar).system;
    return system;
}

void require_whole(const FreeFormDirection& one) {
    require(one.degree >= 1 && one.points > one.degree && one.knots.size() == one.points + one.degree + 1);
}

/// What the knots say is a word that make_knots accepts, up to its degree.
void require_word(const FreeFormDirection& one) {
    KnotVector vector{.degree = static_cast<int>(one.degree), .ends = Ends::Open, .points = one.points, .knots = {}};
    vector.knots.assign(one.knots.begin(), one.knots.end());
    const FittedKnots fitted = fit_knots(halving(), vector);
    require(fitted.fitted.has_value() == fitted.problems.empty());
    if (!fitted.fitted || one.degree > max_degree) return;
    const CheckedKnots knots =
        make_knots(fitted.fitted->system, {static_cast<int>(one.degree), Ends::Open, fitted.fitted->word});
    if (knots.knots) return;
    for (const Number& length : fitted.fitted->system.lengths())
        if (length.to_double() < smallest_length || length.to_double() > largest_length) return;
    require(false);
}

void require_sound(const FreeFormFile& file, const FreeForm& element) {
    require_whole(element.u);
    if (element.v) require_whole(*element.v);
    require(element.vertices.size() == element.u.points * (element.v ? element.v->points : 1));
    for (const std::uint32_t vertex : element.vertices) {
        require(vertex < file.vertices.size() / 4);
        if (element.rational) require(file.vertices[4 * vertex + 3] > 0);
    }
    if (!element.v) require(free_form_polygon(file, element).size() == element.u.points);
    require_word(element.u);
    if (element.v) require_word(*element.v);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    (void)looks_like_obj(text);
    const ParsedFreeForms parsed = read_obj_freeform(text, "fuzz.obj");
    require(parsed.file.has_value() == parsed.errors.empty());
    if (!parsed.file) {
        require(!to_string(parsed.errors).empty());
        return 0;
    }
    for (const double coordinate : parsed.file->vertices) require(std::isfinite(coordinate));
    for (const FreeForm& element : parsed.file->elements) require_sound(*parsed.file, element);
    return 0;
}
