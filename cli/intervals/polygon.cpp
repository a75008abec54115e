// SPDX-License-Identifier: MIT

#include "cli/intervals/polygon.h"

#include "cli/shell/exit_code.h"
#include "cli/intervals/free_form.h"
#include "cli/shell/load.h"
#include "cli/intervals/symbols.h"
#include "internode/io/obj/free_form_input.h"
#include "internode/text/diagnostic.h"

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

InputPolygon read_polygon_file(const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    if (is_obj(input)) {
        const FreeFormFile file = load_free_forms(input);
        const FreeForm& element = chosen_element(file, options.element);
        if (element.v)
            throw failure(ExitCode::Refused, fmt::format("{} is a surface", element_name(file, element)),
                          "a surface has a grammar along each side: --u G --v G");
        return free_form_polygon(file, element);
    }
    refuse_element(options.element, input);
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

std::optional<Symbol> symbol_named(const PlacedText& letter, const Alphabet& alphabet) {
    if (letter.text == "0") return zero_interval;
    return alphabet.find(letter.text);
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
            errors.push_back(unknown_symbol(letter, polygon.source, alphabet));
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

/// What knots, or a word and lengths, come to.
struct Labels {
    IntervalSystem system;
    Word word;
    EndsOption ends = EndsOption::Open;
    std::string origin; ///< of a word that --repeat could repeat; else empty
};

Labels labels_of_word(const IntervalSystem& system, const PolygonOptions& options, const InputPolygon& polygon,
                      int degree) {
    const SaidWord said = settled_word(system, options, polygon);
    const EndsOption ends = settled_ends(options, polygon, said);
    return {system, fitted_word(said, options, ends, polygon.size(), degree), ends,
            options.repeat ? std::string() : said.origin};
}

Labels labels_of_knots(const IntervalSystem& system, const PolygonOptions& options, const InputPolygon& polygon,
                       int degree) {
    if (!options.word.empty() || options.repeat || options.ends == EndsOption::Clamped)
        throw failure(ExitCode::Refused,
                      fmt::format("the knots of {} leave nothing to --word, --repeat and --clamped", polygon.source));
    const EndsOption ends = settled_ends(options, polygon, {});
    KnotWord knots = word_of_knots(system, polygon, polygon.size(), degree,
                                   ends == EndsOption::Closed ? Ends::Circular : Ends::Open);
    const std::optional<Axiom>& axiom = knots.system.grammar().axiom;
    if (axiom && axiom->word != knots.word)
        throw failure(ExitCode::Refused, fmt::format("the knots of {} ({} intervals) and the grammar's axiom ({} "
                                                     "letters) disagree",
                                                     polygon.source, knots.word.size(), axiom->word.size()));
    return {std::move(knots.system), std::move(knots.word), ends, {}};
}

/// --rational: the last coordinate of each point is its weight.
void take_weights(InputPolygon& polygon) {
    if (!polygon.weights.empty())
        throw failure(ExitCode::Refused,
                      fmt::format("{} has weights of its own: leave --rational out", polygon.source));
    if (polygon.dimension < 2)
        throw failure(ExitCode::Refused,
                      fmt::format("--rational needs a coordinate and a weight, but the points of {} have one number",
                                  polygon.source));
    std::vector<double> points;
    for (std::size_t i = 0; i < polygon.points.size(); ++i)
        ((i + 1) % polygon.dimension == 0 ? polygon.weights : points).push_back(polygon.points[i]);
    polygon.points = std::move(points);
    --polygon.dimension;
    if (polygon.columns.size() > 1) polygon.columns.pop_back();
    if (const auto bad = first_bad_weight(polygon.weights))
        throw failure(ExitCode::Refused,
                      fmt::format("the weight of point {} of {} is {}: weights go from {} to {}", *bad + 1,
                                  polygon.source, polygon.weights[*bad], smallest_weight, largest_weight));
}

} // namespace

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

std::string base_name(const std::string& source) {
    const auto slash = source.find_last_of('/');
    return slash == std::string::npos ? source : source.substr(slash + 1);
}

InputPolygon load_polygon(const PolygonOptions& options) {
    InputPolygon polygon = read_polygon_file(options);
    if (options.rational) take_weights(polygon);
    return polygon;
}

LoadedCurve load_curve(const IntervalSystem& system, const PolygonOptions& options) {
    InputPolygon polygon = load_polygon(options);
    const int degree = settled_degree(options, polygon);
    const IntervalSystem scaled = fixed_lengths(system, polygon);
    Labels labels = polygon.knots ? labels_of_knots(scaled, options, polygon, degree)
                                  : labels_of_word(scaled, options, polygon, degree);
    if (labels.ends == EndsOption::Closed) refuse_repeated_point(polygon);
    const bool rational = !polygon.weights.empty();
    const std::size_t polygon_size = polygon.size();
    CurveData data;
    data.degree = degree;
    data.ends = labels.ends == EndsOption::Closed ? Ends::Circular : Ends::Open;
    data.word = std::move(labels.word);
    data.dimension = polygon.dimension + (rational ? 1 : 0);
    data.points =
        rational ? homogeneous(polygon.points, polygon.dimension, polygon.weights) : std::move(polygon.points);
    const std::size_t letters = data.word.size();
    const std::size_t needed = polygon_size + (data.ends == Ends::Open ? static_cast<std::size_t>(degree) : 0);
    CheckedCurve checked = make_curve(labels.system, std::move(data));
    if (!checked.curve) {
        std::string text;
        for (const std::string& problem : checked.problems)
            text += fmt::format("{}: error: {}\n", printable(polygon.source), printable(problem));
        if (!labels.origin.empty() && letters != needed)
            text += fmt::format("hint: --repeat repeats the letters of {} to fit the points\n", labels.origin);
        throw Failure(ExitCode::Refused, text);
    }
    return {*std::move(checked.curve), std::move(polygon.columns), base_name(polygon.source),
            rational ? Coordinates::Homogeneous : Coordinates::Cartesian};
}

LoadedCurve load_polynomial_curve(const IntervalSystem& system, const PolygonOptions& options) {
    LoadedCurve loaded = load_curve(system, options);
    if (loaded.coordinates == Coordinates::Homogeneous)
        throw failure(ExitCode::Refused, fmt::format("the points of {} have weights: this command measures polynomial "
                                                     "curves",
                                                     loaded.source));
    return loaded;
}

} // namespace internode::cli
