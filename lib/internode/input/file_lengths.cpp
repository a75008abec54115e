// SPDX-License-Identifier: MIT

#include "internode/input/file_lengths.h"

#include "internode/curve/parameter.h"
#include "internode/grammar/lexing/limits.h"
#include "internode/input/refuse.h"
#include "internode/text/ascii.h"
#include "internode/text/did_you_mean.h"
#include "internode/text/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace internode {

namespace {

constexpr auto knots_hint = "any knots fit a grammar of one symbol (@bisection, @trisection); others have their "
                            "lengths, at a scale that \"lengths\" may say";

/// Lengths of a grammar whose only symbol is not among the names, as our own output has them after a refinement by
/// knots: one symbol a length.
bool names_other_symbols(const IntervalSystem& system, const std::vector<InputLength>& lengths) {
    return system.alphabet().size() == 1 && system.grammar().lengths.empty() && !lengths.empty() &&
           std::ranges::none_of(lengths, [&](const InputLength& length) {
               return system.alphabet().find(length.symbol.text).has_value();
           });
}

IntervalSystem symbol_a_length(const IntervalSystem& system, const InputPolygon& polygon) {
    std::vector<std::string> names;
    std::vector<Rational> lengths;
    std::vector<Diagnostic> errors;
    for (const InputLength& length : polygon.lengths) {
        names.push_back(length.symbol.text);
        lengths.push_back(length.coefficients.front());
        if (!is_symbol_name(names.back()))
            errors.push_back(unknown_symbol(length.symbol, polygon.source, system.alphabet()));
        else if (length.coefficients.size() != 1 || sgn(lengths.back()) <= 0)
            errors.push_back(
                diagnostic_at(length.symbol, polygon.source,
                              fmt::format("the length of `{}` must be a positive rational", names.back())));
    }
    if (names.size() > max_symbols)
        refuse_all(
            polygon.source, {},
            {fmt::format("{} lengths, more than the {} symbols that a grammar may have", names.size(), max_symbols)});
    if (!errors.empty()) refuse(std::move(errors));
    return one_symbol_a_length(system, names, lengths);
}

/// What is wrong with a length; empty when nothing is.
std::string length_problem(const IntervalSystem& system, const InputLength& length) {
    if (length.coefficients.size() > system.field().degree())
        return fmt::format("the length of `{}` has {} coefficients, but the field has degree {}", length.symbol.text,
                           length.coefficients.size(), system.field().degree());
    if (length.coefficients.empty()) return fmt::format("the length of `{}` has no coefficients", length.symbol.text);
    if (Number(system.field(), length.coefficients).sign() <= 0)
        return fmt::format("the length of `{}` must be positive", length.symbol.text);
    return {};
}

std::string too_many_coefficients(const IntervalSystem& system, const std::string& what, std::size_t count) {
    return fmt::format("{} has {} coefficients, but the field has degree {}", what, count, system.field().degree());
}

/// A knot, counted from 0, in the field.
Number knot_of(const IntervalSystem& system, const InputPolygon& polygon, std::size_t place) {
    assert(polygon.knots && place < polygon.knots->size());
    const InputNumber& knot = (*polygon.knots)[place];
    if (knot.size() > system.field().degree())
        refuse(fmt::format("{}: {}", polygon.source,
                           too_many_coefficients(system, fmt::format("knot {}", place + 1), knot.size())));
    return {system.field(), knot};
}

KnotVector knot_vector(const IntervalSystem& system, const InputPolygon& polygon, const KnotShape& shape) {
    KnotVector vector{.degree = shape.degree, .ends = shape.ends, .points = shape.points, .knots = {}};
    vector.knots.reserve(polygon.knots->size());
    for (std::size_t i = 0; i < polygon.knots->size(); ++i) vector.knots.push_back(knot_of(system, polygon, i));
    for (const InputLength& length : polygon.lengths)
        if (const auto symbol = system.alphabet().find(length.symbol.text)) vector.fixed.push_back(*symbol);
    return vector;
}

/// Whether the first and the last knot of an open polygon are left out, as the short form has them.
bool is_short(const InputPolygon& polygon, const KnotShape& shape) {
    return shape.ends == Ends::Open &&
           polygon.knots->size() + 1 == shape.points + static_cast<std::size_t>(shape.degree);
}

/// Two units in the last place of the largest knot: what rounding and summing may have done to one of our own.
bool agrees(const Number& exact, double position, double largest) {
    const double given = exact.to_double();
    return std::abs(given - position) <= 2 * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

bool is_symbol_name(const std::string& name) {
    const auto follows = [](char c) { return is_ascii_digit(c) || c == '_' || c == '\''; };
    return !name.empty() && name.size() <= max_name_bytes && is_ascii_letter(name.front()) &&
           std::all_of(name.begin() + 1, name.end(), follows);
}

Diagnostic diagnostic_at(const PlacedText& text, const std::string& source, std::string message) {
    Diagnostic diagnostic;
    diagnostic.source = source;
    diagnostic.line = text.place.line;
    diagnostic.column = text.place.column;
    diagnostic.message = std::move(message);
    return diagnostic;
}

Diagnostic unknown_symbol(const PlacedText& name, const std::string& source, const Alphabet& alphabet) {
    const std::string meant = did_you_mean(name.text, alphabet.names());
    Diagnostic diagnostic = diagnostic_at(name, source, fmt::format("`{}` is no symbol of the grammar", name.text));
    if (!meant.empty()) diagnostic.hint = fmt::format("did you mean `{}`?", meant);
    return diagnostic;
}

std::vector<FixedLength> positive_lengths(const IntervalSystem& system, const std::vector<InputLength>& lengths,
                                          const std::string& source) {
    std::vector<FixedLength> fixed;
    std::vector<Diagnostic> errors;
    for (const InputLength& length : lengths) {
        const auto symbol = system.alphabet().find(length.symbol.text);
        const std::string problem = symbol ? length_problem(system, length) : std::string();
        if (!symbol)
            errors.push_back(unknown_symbol(length.symbol, source, system.alphabet()));
        else if (!problem.empty())
            errors.push_back(diagnostic_at(length.symbol, source, problem));
        else
            fixed.push_back({*symbol, Number(system.field(), length.coefficients)});
    }
    if (!errors.empty()) refuse(std::move(errors));
    return fixed;
}

IntervalSystem fixed_lengths(const IntervalSystem& system, const InputPolygon& polygon) {
    if (polygon.lengths.empty()) return system;
    if (names_other_symbols(system, polygon.lengths)) return symbol_a_length(system, polygon);
    FixedLengths fixed = with_lengths(system, positive_lengths(system, polygon.lengths, polygon.source));
    if (fixed.system) return *std::move(fixed.system);
    std::vector<std::string> messages;
    for (const LengthConflict& conflict : fixed.conflicts) messages.push_back(conflict.message);
    refuse_all(polygon.source, {}, messages,
               "one length per final class is enough, the others follow; \"exact\" takes numbers of the field");
}

IntervalSystem scaled_lengths(const IntervalSystem& system, const std::vector<Symbol>& symbols, int levels) {
    assert(levels >= 0);
    if (symbols.empty()) return system;
    const Number scale = pow(system.ratio(), levels);
    std::vector<FixedLength> lengths;
    for (const Symbol symbol : symbols) lengths.push_back({symbol, system.length(symbol) * scale});
    FixedLengths fixed = with_lengths(system, lengths);
    if (!fixed.system) refuse(fixed.conflicts.front().message);
    return *std::move(fixed.system);
}

KnotWord word_of_knots(const IntervalSystem& system, const InputPolygon& polygon, const KnotShape& shape) {
    assert(polygon.knots);
    FittedKnots fitted = fit_knots(system, knot_vector(system, polygon, shape));
    if (!fitted.fitted) refuse_all(polygon.source, shape.before, fitted.problems, knots_hint);
    if (polygon.origin && file_origin(system, polygon, shape) != fitted.fitted->origin)
        refuse_all(polygon.source, shape.before, {"\"origin\" is not the knot where the domain begins"});
    return *std::move(fitted.fitted);
}

Number file_origin(const IntervalSystem& system, const InputPolygon& polygon, const KnotShape& shape) {
    if (polygon.origin) {
        if (polygon.origin->size() > system.field().degree())
            refuse_all(polygon.source, shape.before,
                       {too_many_coefficients(system, "\"origin\"", polygon.origin->size())});
        return {system.field(), *polygon.origin};
    }
    if (!polygon.knots) return {};
    const auto d = static_cast<std::size_t>(shape.degree);
    const std::size_t place = shape.ends == Ends::Circular ? 0 : d - (is_short(polygon, shape) ? 1 : 0);
    if (place >= polygon.knots->size())
        refuse_all(polygon.source, shape.before,
                   {fmt::format("{} knots are too few for degree {}", polygon.knots->size(), shape.degree)});
    return knot_of(system, polygon, place);
}

void require_knots(const InputPolygon& polygon, const Knots& knots, const std::string& before) {
    if (!polygon.knots) return;
    const KnotShape shape{knots.size(), knots.degree(), knots.ends(), before};
    const std::vector<double> positions = knot_positions(knots);
    const std::size_t left_out = is_short(polygon, shape) ? 1 : 0;
    if (polygon.knots->size() + 2 * left_out != positions.size())
        refuse_all(polygon.source, before,
                   {fmt::format("{} knots beside a word that has {}", polygon.knots->size(), positions.size())});
    const double largest = std::max(std::abs(positions.front()), std::abs(positions.back()));
    for (std::size_t i = 0; i < polygon.knots->size(); ++i) {
        const Number knot = knot_of(knots.system(), polygon, i);
        if (agrees(knot, positions[i + left_out], largest)) continue;
        refuse_all(polygon.source, before,
                   {fmt::format("knot {} is {}, but the word, its lengths and the origin say {}", i + 1,
                                to_string(knot.to_double()), to_string(positions[i + left_out]))});
    }
}

} // namespace internode
