// SPDX-License-Identifier: MIT

#include "cli/intervals/symbols.h"

#include "cli/shell/exit_code.h"
#include "internode/grammar/lexing/limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

Diagnostic at(const PlacedText& text, const std::string& source, std::string message, std::string hint) {
    Diagnostic diagnostic;
    diagnostic.source = source;
    diagnostic.line = text.place.line;
    diagnostic.column = text.place.column;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    return diagnostic;
}

/// Lengths of a grammar whose only symbol is not among the names, as our own output has them after a refinement by
/// knots: one symbol a length.
bool names_other_symbols(const IntervalSystem& system, const std::vector<InputLength>& lengths) {
    return system.alphabet().size() == 1 && system.grammar().lengths.empty() && !lengths.empty() &&
           std::ranges::none_of(lengths, [&](const InputLength& length) {
               return system.alphabet().find(length.symbol.text).has_value();
           });
}

/// "A1" … as the language has them, so that no name of a file is stranger than a grammar's.
bool is_symbol_name(const std::string& name) {
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    const auto follows = [](char c) { return (c >= '0' && c <= '9') || c == '_' || c == '\''; };
    return !name.empty() && name.size() <= max_name_bytes && is_letter(name.front()) &&
           std::all_of(name.begin() + 1, name.end(), follows);
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
            errors.push_back(at(length.symbol, polygon.source,
                                fmt::format("the length of `{}` must be a positive rational", names.back()), {}));
    }
    if (!errors.empty()) throw Failure(ExitCode::Refused, to_string(errors));
    return one_symbol_a_length(system, names, lengths);
}

/// The lengths as numbers of the field. \throw Failure (Refused)
std::vector<FixedLength> said_lengths(const IntervalSystem& system, const InputPolygon& polygon) {
    std::vector<FixedLength> lengths;
    std::vector<Diagnostic> errors;
    for (const InputLength& length : polygon.lengths) {
        const auto symbol = system.alphabet().find(length.symbol.text);
        if (!symbol)
            errors.push_back(unknown_symbol(length.symbol, polygon.source, system.alphabet()));
        else if (length.coefficients.size() > system.field().degree())
            errors.push_back(at(length.symbol, polygon.source,
                                fmt::format("the length of `{}` has {} coefficients, but the field has degree {}",
                                            length.symbol.text, length.coefficients.size(), system.field().degree()),
                                {}));
        else
            lengths.push_back({*symbol, Number(system.field(), length.coefficients)});
    }
    if (!errors.empty()) throw Failure(ExitCode::Refused, to_string(errors));
    return lengths;
}

KnotVector knot_vector(const IntervalSystem& system, const InputPolygon& polygon, std::size_t points, int degree,
                       Ends ends) {
    KnotVector vector{.degree = degree, .ends = ends, .points = points, .knots = {}};
    vector.knots.reserve(polygon.knots->size());
    for (const InputNumber& knot : *polygon.knots) {
        if (knot.size() > system.field().degree())
            throw failure(ExitCode::Refused,
                          fmt::format("{}: knot {} has {} coefficients, but the field has degree {}", polygon.source,
                                      vector.knots.size() + 1, knot.size(), system.field().degree()));
        vector.knots.emplace_back(system.field(), knot);
    }
    for (const InputLength& length : polygon.lengths)
        if (const auto symbol = system.alphabet().find(length.symbol.text)) vector.fixed.push_back(*symbol);
    return vector;
}

} // namespace

Diagnostic unknown_symbol(const PlacedText& name, const std::string& source, const Alphabet& alphabet) {
    const std::string meant = did_you_mean(name.text, alphabet.names());
    return at(name, source, fmt::format("`{}` is no symbol of the grammar", name.text),
              meant.empty() ? std::string() : fmt::format("did you mean `{}`?", meant));
}

IntervalSystem fixed_lengths(const IntervalSystem& system, const InputPolygon& polygon) {
    if (polygon.lengths.empty()) return system;
    if (names_other_symbols(system, polygon.lengths)) return symbol_a_length(system, polygon);
    FixedLengths fixed = with_lengths(system, said_lengths(system, polygon));
    if (fixed.system) return *std::move(fixed.system);
    std::string text;
    for (const LengthConflict& conflict : fixed.conflicts)
        text += fmt::format("{}: error: {}\n", printable(polygon.source), printable(conflict.message));
    text += "hint: one length per final class is enough, the others follow; \"exact\" takes numbers of the field\n";
    throw Failure(ExitCode::Refused, text);
}

KnotWord word_of_knots(const IntervalSystem& system, const InputPolygon& polygon, std::size_t points, int degree,
                       Ends ends, const std::string& along) {
    FittedKnots fitted = fit_knots(system, knot_vector(system, polygon, points, degree, ends));
    if (fitted.fitted) return *std::move(fitted.fitted);
    std::string text;
    for (const std::string& problem : fitted.problems)
        text += fmt::format("{}: error: {}{}\n", printable(polygon.source), along, printable(problem));
    text += "hint: any knots fit a grammar of one symbol (@bisection, @trisection); others have their lengths, at a "
            "scale that \"lengths\" may say\n";
    throw Failure(ExitCode::Refused, text);
}

} // namespace internode::cli
