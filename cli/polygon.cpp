// SPDX-License-Identifier: MIT

#include "cli/polygon.h"

#include "cli/exit_code.h"
#include "cli/load.h"
#include "internode/grammar/diagnostic.h"
#include "internode/io/polygon.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

/// A word before the number of its letters is settled.
struct SaidWord {
    Axiom axiom;
    bool says_ends = false;
    std::string origin; ///< "--word", "the polygon's word", "the axiom"
};

InputPolygon read_polygon_file(const std::string& place) {
    const LoadedText input = load_text(place);
    ParsedPolygon parsed = read_polygon(input.text, input.source);
    if (!parsed.polygon) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return *std::move(parsed.polygon);
}

int settled_degree(const PolygonOptions& options, const InputPolygon& polygon) {
    if (!options.degree && !polygon.degree)
        throw failure(ExitCode::Usage, "no degree", "give -d, or \"degree\" in the polygon's JSON");
    if (options.degree && polygon.degree && static_cast<std::size_t>(*options.degree) != *polygon.degree)
        throw failure(ExitCode::Refused, fmt::format("-d {} disagrees with \"degree\": {} of {}", *options.degree,
                                                     *polygon.degree, polygon.source));
    if (options.degree) return *options.degree;
    if (*polygon.degree < 1 || *polygon.degree > max_degree)
        throw failure(ExitCode::Refused, fmt::format("\"degree\": {} of {} is not between 1 and {}", *polygon.degree,
                                                     polygon.source, max_degree));
    return static_cast<int>(*polygon.degree);
}

Diagnostic at(const PlacedText& text, const InputPolygon& polygon, std::string message, std::string hint) {
    Diagnostic diagnostic;
    diagnostic.source = polygon.source;
    diagnostic.line = text.place.line;
    diagnostic.column = text.place.column;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    return diagnostic;
}

std::optional<Symbol> symbol_named(const PlacedText& letter, const Alphabet& alphabet) {
    if (letter.text == "0") return zero_interval;
    return alphabet.find(letter.text);
}

Diagnostic unknown_symbol(const PlacedText& letter, const InputPolygon& polygon, const Alphabet& alphabet) {
    const std::string meant = did_you_mean(letter.text, alphabet.names());
    return at(letter, polygon, fmt::format("`{}` is no symbol of the grammar", letter.text),
              meant.empty() ? std::string() : fmt::format("did you mean `{}`?", meant));
}

/// The word that the JSON gives, as an array of names or as a text.
std::optional<SaidWord> polygon_word(const InputPolygon& polygon, const Alphabet& alphabet) {
    SaidWord said;
    said.origin = "the polygon's word";
    if (polygon.word_text) {
        ParsedWord word = parse_word(polygon.word_text->text, alphabet, polygon.source + ": \"word\"");
        if (!word.errors.empty()) throw Failure(ExitCode::Refused, to_string(word.errors));
        said.axiom = std::move(word.axiom);
        said.says_ends = word.says_ends;
        return said;
    }
    if (!polygon.word_letters) return std::nullopt;
    std::vector<Diagnostic> errors;
    for (const PlacedText& letter : *polygon.word_letters) {
        if (const auto symbol = symbol_named(letter, alphabet))
            said.axiom.word.push_back(*symbol);
        else
            errors.push_back(unknown_symbol(letter, polygon, alphabet));
    }
    if (!errors.empty()) throw Failure(ExitCode::Refused, to_string(errors));
    return said;
}

SaidWord settled_word(const IntervalSystem& system, const PolygonOptions& options, const InputPolygon& polygon) {
    if (!options.word.empty()) {
        ParsedWord word = load_word(options.word, system.alphabet());
        return {std::move(word.axiom), word.says_ends, "--word"};
    }
    const std::optional<Axiom>& axiom = system.grammar().axiom;
    std::optional<SaidWord> said = polygon_word(polygon, system.alphabet());
    if (said && axiom && said->axiom.word != axiom->word)
        throw failure(ExitCode::Refused,
                      fmt::format("the polygon's word ({} letters) and the grammar's axiom ({} letters) disagree",
                                  said->axiom.word.size(), axiom->word.size()),
                      "say which one is meant with --word");
    if (said) return *std::move(said);
    if (axiom) return {*axiom, true, "the axiom"};
    throw failure(ExitCode::Refused, fmt::format("no word for the {} points of {}", polygon.size(), polygon.source),
                  fmt::format("name the knot intervals, for example --word '{}' --repeat",
                              to_string(Word{to_symbol(0)}, system.alphabet())));
}

EndsOption settled_ends(const PolygonOptions& options, const InputPolygon& polygon, const SaidWord& word) {
    const bool says_circular = word.says_ends && word.axiom.ends == Ends::Circular;
    if (options.ends != EndsOption::Unsaid) {
        const bool closed = options.ends == EndsOption::Closed;
        if (polygon.closed && *polygon.closed != closed)
            throw failure(ExitCode::Refused,
                          fmt::format("{} disagrees with \"closed\": {} of {}",
                                      closed ? "--closed" : (options.ends == EndsOption::Open ? "--open" : "--clamped"),
                                      *polygon.closed, polygon.source));
        if (says_circular && !closed)
            throw failure(ExitCode::Refused,
                          fmt::format("{} is circular: `( … )`, but the ends are open", word.origin));
        return options.ends;
    }
    if (polygon.closed) return *polygon.closed ? EndsOption::Closed : EndsOption::Open;
    return says_circular ? EndsOption::Closed : EndsOption::Open;
}

/// The letters of the whole curve: repeated, cut and clamped as asked.
Word fitted_word(const SaidWord& said, const PolygonOptions& options, EndsOption ends, std::size_t points, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    Word word = said.axiom.word;
    if (options.repeat) {
        if (ends == EndsOption::Clamped && points <= d)
            throw failure(
                ExitCode::Refused,
                fmt::format("a clamped curve of degree {} needs at least {} points, not {}", d, d + 1, points));
        const std::size_t needed =
            ends == EndsOption::Closed ? points : (ends == EndsOption::Open ? points + d : points - d);
        if (word.size() > needed)
            throw failure(ExitCode::Refused, fmt::format("{} has {} letters, more than the {} that {} points need",
                                                         said.origin, word.size(), needed, points));
        word = repeated(word, needed);
    }
    return ends == EndsOption::Clamped ? clamped(word, degree) : word;
}

void refuse_repeated_point(const InputPolygon& polygon) {
    const std::size_t n = polygon.size();
    if (n < 2) return;
    const auto first = polygon.points.begin();
    const auto last = first + static_cast<std::ptrdiff_t>((n - 1) * polygon.dimension);
    if (std::equal(last, polygon.points.end(), first))
        throw failure(ExitCode::Refused,
                      fmt::format("the last of the {} points of {} repeats the first", n, polygon.source),
                      "a closed polygon joins them by itself: drop the last point");
}

/// The system with the lengths that the JSON fixes.
IntervalSystem fixed_lengths(const IntervalSystem& system, const InputPolygon& polygon) {
    if (polygon.lengths.empty()) return system;
    std::vector<FixedLength> lengths;
    std::vector<Diagnostic> errors;
    for (const InputLength& length : polygon.lengths) {
        const auto symbol = system.alphabet().find(length.symbol.text);
        if (!symbol)
            errors.push_back(unknown_symbol(length.symbol, polygon, system.alphabet()));
        else if (length.coefficients.size() > system.field().degree())
            errors.push_back(at(length.symbol, polygon,
                                fmt::format("the length of `{}` has {} coefficients, but the field has degree {}",
                                            length.symbol.text, length.coefficients.size(), system.field().degree()),
                                {}));
        else
            lengths.push_back({*symbol, Number(system.field(), length.coefficients)});
    }
    if (!errors.empty()) throw Failure(ExitCode::Refused, to_string(errors));
    FixedLengths fixed = with_lengths(system, lengths);
    if (fixed.system) return *std::move(fixed.system);
    std::string text;
    for (const LengthConflict& conflict : fixed.conflicts)
        text += fmt::format("{}: error: {}\n", printable(polygon.source), printable(conflict.message));
    text += "hint: one length per final class is enough, the others follow; \"exact\" takes numbers of the field\n";
    throw Failure(ExitCode::Refused, text);
}

} // namespace

LoadedCurve load_curve(const IntervalSystem& system, const PolygonOptions& options) {
    InputPolygon polygon = read_polygon_file(options.place);
    const int degree = settled_degree(options, polygon);
    const SaidWord said = settled_word(system, options, polygon);
    const EndsOption ends = settled_ends(options, polygon, said);
    if (ends == EndsOption::Closed) refuse_repeated_point(polygon);
    const std::size_t polygon_size = polygon.size();
    CurveData data;
    data.degree = degree;
    data.ends = ends == EndsOption::Closed ? Ends::Circular : Ends::Open;
    data.word = fitted_word(said, options, ends, polygon.size(), degree);
    data.dimension = polygon.dimension;
    data.points = std::move(polygon.points);
    const std::size_t letters = data.word.size();
    const std::size_t needed = polygon_size + (data.ends == Ends::Open ? static_cast<std::size_t>(degree) : 0);
    CheckedCurve checked = make_curve(fixed_lengths(system, polygon), std::move(data));
    if (!checked.curve) {
        std::string text;
        for (const std::string& problem : checked.problems)
            text += fmt::format("{}: error: {}\n", printable(polygon.source), printable(problem));
        if (!options.repeat && letters != needed)
            text += fmt::format("hint: --repeat repeats the letters of {} to fit the points\n", said.origin);
        throw Failure(ExitCode::Refused, text);
    }
    const auto slash = polygon.source.find_last_of('/');
    return {*std::move(checked.curve), std::move(polygon.columns),
            slash == std::string::npos ? polygon.source : polygon.source.substr(slash + 1)};
}

} // namespace internode::cli
