// SPDX-License-Identifier: MIT
//
// Degree, then lengths, then word and ends; make_curve() checks the whole once, and what it says is handed on.

#include "internode/input/settled_curve.h"

#include "internode/input/file_lengths.h"
#include "internode/input/plain_polygon.h"
#include "internode/input/refuse.h"
#include "internode/input/said_word.h"

#include <fmt/format.h>

#include <cassert>

namespace internode {

namespace {

std::string_view option_name(EndsChoice ends) {
    if (ends == EndsChoice::Closed) return "--closed";
    return ends == EndsChoice::Open ? "--open" : "--clamped";
}

EndsChoice settled_ends(const CurveOptions& options, const InputPolygon& polygon, const SaidWord& word) {
    if (options.ends != EndsChoice::Unsaid) {
        const bool closed = options.ends == EndsChoice::Closed;
        if (polygon.closed && *polygon.closed != closed)
            refuse(fmt::format("{} disagrees with \"closed\": {} of {}", option_name(options.ends), *polygon.closed,
                               polygon.source));
        if (says_circular(word) && !closed)
            refuse(fmt::format("{} is circular: `( … )`, but the ends are open", word.origin));
        return options.ends;
    }
    if (polygon.closed) return *polygon.closed ? EndsChoice::Closed : EndsChoice::Open;
    return says_circular(word) ? EndsChoice::Closed : EndsChoice::Open;
}

/// The letters of the whole curve: repeated, cut and clamped as asked.
Word fitted_word(const SaidWord& said, bool repeat, EndsChoice ends, std::size_t points, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    Word word = said.axiom.word;
    if (repeat) {
        if (ends == EndsChoice::Clamped && points <= d)
            refuse(fmt::format("a clamped curve of degree {} needs at least {} points, not {}", d, d + 1, points));
        const std::size_t needed =
            ends == EndsChoice::Closed ? points : (ends == EndsChoice::Open ? points + d : points - d);
        if (word.size() > needed)
            refuse(fmt::format("{} has {} letters, more than the {} that {} points need", said.origin, word.size(),
                               needed, points));
        word = repeated(word, needed);
    }
    return ends == EndsChoice::Clamped ? clamped(word, degree) : word;
}

/// What knots, or a word and lengths, come to.
struct Labels {
    IntervalSystem system;
    Word word;
    EndsChoice ends = EndsChoice::Open;
    Number parameter_origin{};
    std::string origin{}; ///< where a word comes from that repetition could fit; else empty
};

Ends ends_of(EndsChoice ends) {
    return ends == EndsChoice::Closed ? Ends::Circular : Ends::Open;
}

Labels labels_of_word(const IntervalSystem& system, const CurveOptions& options, const InputPolygon& polygon,
                      int degree) {
    const SaidWord said = settled_word(system, options.word, polygon, polygon.size(), {});
    const EndsChoice ends = settled_ends(options, polygon, said);
    const KnotShape shape{polygon.size(), degree, ends_of(ends)};
    return {system, fitted_word(said, options.repeat, ends, polygon.size(), degree), ends,
            file_origin(system, polygon, shape), options.repeat ? std::string() : said.origin};
}

Labels labels_of_knots(const IntervalSystem& system, const CurveOptions& options, const InputPolygon& polygon,
                       int degree) {
    if (!options.word.empty() || options.repeat || options.ends == EndsChoice::Clamped)
        refuse(fmt::format("the knots of {} leave nothing to --word, --repeat and --clamped", polygon.source));
    const EndsChoice ends = settled_ends(options, polygon, {});
    KnotWord knots = word_of_knots(system, polygon, {polygon.size(), degree, ends_of(ends)});
    const std::optional<Axiom>& axiom = knots.system.grammar().axiom;
    if (axiom && axiom->word != knots.word)
        refuse(fmt::format("the knots of {} ({} intervals) and the grammar's axiom ({} letters) disagree",
                           polygon.source, knots.word.size(), axiom->word.size()));
    return {std::move(knots.system), std::move(knots.word), ends, std::move(knots.origin)};
}

/// Points, homogeneous where they have weights, over the settled word.
Curve checked_curve(const Labels& labels, InputPolygon& polygon, int degree) {
    assert(polygon.weights.empty() || polygon.weights.size() == polygon.size());
    const bool rational = !polygon.weights.empty();
    const std::size_t points = polygon.size();
    CurveData data;
    data.degree = degree;
    data.ends = ends_of(labels.ends);
    data.word = labels.word;
    data.origin = labels.parameter_origin;
    data.dimension = polygon.dimension + (rational ? 1 : 0);
    data.points =
        rational ? homogeneous(polygon.points, polygon.dimension, polygon.weights) : std::move(polygon.points);
    const std::size_t needed = points + (data.ends == Ends::Open ? static_cast<std::size_t>(degree) : 0);
    CheckedCurve checked = make_curve(labels.system, std::move(data));
    if (checked.curve) return *std::move(checked.curve);
    const bool may_repeat = !labels.origin.empty() && labels.word.size() != needed;
    refuse_all(polygon.source, {}, checked.problems,
               may_repeat ? fmt::format("--repeat repeats the letters of {} to fit the points", labels.origin)
                          : std::string());
}

} // namespace

Settled<SettledCurve> settle_curve(const IntervalSystem& system, InputPolygon polygon, const CurveOptions& options) {
    assert(polygon.dimension >= 1 && polygon.size() >= 1);
    return settled([&] {
        if (options.rational) polygon = take(with_weights(std::move(polygon)));
        const int degree = settled_degree(options.degree, polygon, {});
        const IntervalSystem scaled = fixed_lengths(system, polygon);
        const bool has_word = polygon.word_text || polygon.word_letters;
        const Labels labels = polygon.knots && !has_word ? labels_of_knots(scaled, options, polygon, degree)
                                                         : labels_of_word(scaled, options, polygon, degree);
        if (labels.ends == EndsChoice::Closed)
            if (Refusal repeated = repeated_point(polygon); !repeated.errors.empty())
                refuse(std::move(repeated.errors));
        const Coordinates coordinates = polygon.weights.empty() ? Coordinates::Cartesian : Coordinates::Homogeneous;
        Curve curve = checked_curve(labels, polygon, degree);
        // A word of the caller's takes the place of the file's, and of the knots that belong to that.
        if (options.word.empty()) require_knots(polygon, curve.knots(), {});
        return SettledCurve{std::move(curve), std::move(polygon.columns), base_name(polygon.source), coordinates,
                            std::move(polygon.break_text)};
    });
}

Refusal placed(Refusal refusal, const InputPolygon& polygon) {
    if (polygon.line == 0) return refusal;
    for (Diagnostic& error : refusal.errors) {
        if (error.line != 0) continue;
        error.source = polygon.source;
        error.line = polygon.line;
    }
    return refusal;
}

} // namespace internode
