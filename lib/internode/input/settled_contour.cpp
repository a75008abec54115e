// SPDX-License-Identifier: MIT
//
// First come the coarse word and the ends, from the caller, the axiom or the file's knots. Then the number of points
// that the word can have after so many levels; then the points, brought to that number.

#include "internode/input/settled_contour.h"

#include "internode/curve/clamping.h"
#include "internode/curve/refinement.h"
#include "internode/curve/reverse/possible_size.h"
#include "internode/curve/reverse/pyramid.h"
#include "internode/input/coarse_word.h"
#include "internode/input/file_lengths.h"
#include "internode/input/plain_polygon.h"
#include "internode/input/refuse.h"
#include "internode/input/said_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// What knots of the file say: the word of the fine polygon, and the system that has its lengths.
using FineKnots = std::optional<KnotWord>;

bool is_closed(const ContourOptions& options, const InputPolygon& polygon) {
    if (options.curve.ends != EndsChoice::Unsaid) return options.curve.ends == EndsChoice::Closed;
    return polygon.closed.value_or(false);
}

FineKnots fine_knots(const IntervalSystem& system, const InputPolygon& polygon, const ContourOptions& options,
                     int degree) {
    const bool has_word = polygon.word_text || polygon.word_letters;
    if (!polygon.knots || has_word) return std::nullopt;
    const Ends ends = is_closed(options, polygon) ? Ends::Circular : Ends::Open;
    return word_of_knots(fixed_lengths(system, polygon), polygon, {polygon.size(), degree, ends});
}

/// The fine word, so many levels back.
Axiom coarse_word_of_knots(const KnotWord& fine, const InputPolygon& polygon, const ContourOptions& options,
                           int degree) {
    assert(!polygon.word_text && !polygon.word_letters);
    if (!options.levels) ask(fmt::format("the knots of {} leave the number of levels open", polygon.source), "give -n");
    const Ends ends = is_closed(options, polygon) ? Ends::Circular : Ends::Open;
    std::optional<Word> word = fine.word;
    for (std::uint64_t level = 0; level < *options.levels; ++level) {
        const std::size_t least = ends == Ends::Open ? 2 * static_cast<std::size_t>(degree) + 1 : 1;
        if (word->size() >= least) word = coarser_word(fine.system.rules(), *word, degree, ends);
        if (!word || word->size() < least)
            refuse(fmt::format("the knots of {} are no refinement of {} levels", polygon.source, *options.levels),
                   "fewer levels: -n");
    }
    return {*std::move(word), ends};
}

SaidWord coarse_word(const IntervalSystem& system, const InputPolygon& polygon, const ContourOptions& options,
                     const FineKnots& fine, int degree) {
    if (!options.curve.word.empty()) return callers_word(options.curve.word, system.alphabet(), {});
    if (system.grammar().axiom) return {*system.grammar().axiom, "the axiom"};
    if (fine) return {coarse_word_of_knots(*fine, polygon, options, degree), "the knots"};
    refuse("no word for the coarse polygon", fmt::format("name its knot intervals, for example --word '{}' --repeat",
                                                         to_string(Word{to_symbol(0)}, system.alphabet())));
}

/// Whether both ends of the word are d zeros.
bool has_clamped_ends(const KnotWord& fine, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    const auto is_zero = [](Symbol symbol) { return symbol == zero_interval; };
    const WordView word(fine.word);
    return word.size() >= d && std::ranges::all_of(word.first(d), is_zero) &&
           std::ranges::all_of(word.last(d), is_zero);
}

PolygonEnds contour_ends(const ContourOptions& options, const InputPolygon& polygon, const SaidWord& said) {
    const EndsChoice ends = options.curve.ends;
    const bool circular = says_circular(said);
    const bool closed = ends == EndsChoice::Closed || (ends == EndsChoice::Unsaid && polygon.closed.value_or(circular));
    if (polygon.closed && *polygon.closed != closed)
        refuse(fmt::format("the ends asked for disagree with \"closed\": {} of {}", *polygon.closed, polygon.source));
    if (circular && !closed) refuse("the coarse word is circular: `( … )`, but the ends are open");
    if (closed) return PolygonEnds::Closed;
    return ends == EndsChoice::Clamped ? PolygonEnds::Clamped : PolygonEnds::Open;
}

/// The word with its ends: a word of the caller's is that of the domain where the knots clamp the ends.
CoarseWord settled_coarse(const IntervalSystem& system, const InputPolygon& polygon, const ContourOptions& options,
                          const FineKnots& fine, int degree) {
    const bool from_knots = fine && options.curve.word.empty() && !system.grammar().axiom;
    const SaidWord said = coarse_word(system, polygon, options, fine, degree);
    CoarseWord coarse;
    coarse.letters = said.axiom.word;
    coarse.repeat = options.curve.repeat;
    coarse.degree = degree;
    coarse.ends = contour_ends(options, polygon, said);
    if (coarse.ends == PolygonEnds::Closed || !fine) return coarse;
    const bool whole = from_knots || said.axiom.word.front() == zero_interval;
    const bool clamps = options.curve.ends != EndsChoice::Open && has_clamped_ends(*fine, degree);
    coarse.ends = clamps && !whole ? PolygonEnds::Clamped : PolygonEnds::Open;
    return coarse;
}

std::string possible_text(const PossibleSizes& sizes) {
    const auto text = [](const PossibleSize& size, const char* side) {
        return fmt::format("{} {} ({} {} down)", size.points, side, size.levels, size.levels == 1 ? "level" : "levels");
    };
    if (sizes.below && sizes.above) return text(*sizes.below, "below") + " and " + text(*sizes.above, "above");
    if (sizes.below) return text(*sizes.below, "below");
    return sizes.above ? text(*sizes.above, "above") : std::string("none");
}

/// The possible size that is nearest, or below; the one below of two alike.
PossibleSize chosen_size(const PossibleSizes& sizes, const ContourOptions& options, const InputPolygon& polygon) {
    const std::uint64_t points = polygon.size();
    if (sizes.exact()) return *sizes.below;
    const bool cut = options.fit == FitChoice::Cut;
    if (options.fit == FitChoice::Refuse || (cut && !sizes.below) || (!sizes.below && !sizes.above))
        refuse(fmt::format("{} has {} points, which no refinement of the coarse word gives; the nearest numbers are {}",
                           polygon.source, points, possible_text(sizes)),
               "--resample to the nearest, --cut to the one below, another --word or -n");
    if (!sizes.above) return *sizes.below;
    if (!sizes.below) return *sizes.above;
    assert(sizes.below->points < points && points < sizes.above->points);
    return cut || points - sizes.below->points <= sizes.above->points - points ? *sizes.below : *sizes.above;
}

/// The symbols whose lengths the file says; its knots say them all.
std::vector<Symbol> said_symbols(const IntervalSystem& system, const InputPolygon& polygon) {
    std::vector<Symbol> symbols;
    const bool has_word = polygon.word_text || polygon.word_letters;
    for (const InputLength& length : polygon.lengths)
        if (const auto symbol = system.alphabet().find(length.symbol.text)) symbols.push_back(*symbol);
    if (!polygon.knots || has_word) return symbols;
    symbols.clear();
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        if (system.occurs(to_symbol(i))) symbols.push_back(to_symbol(i));
    return symbols;
}

Knots coarse_knots(const IntervalSystem& fine_system, const InputPolygon& polygon, const CoarseWord& coarse,
                   const PossibleSize& size) {
    const Ends ends = coarse.ends == PolygonEnds::Closed ? Ends::Circular : Ends::Open;
    Number origin = file_origin(fine_system, polygon, {polygon.size(), coarse.degree, ends});
    CheckedKnots checked = make_knots(scaled_lengths(fine_system, said_symbols(fine_system, polygon), size.levels),
                                      {coarse.degree, ends, size.word, std::move(origin)});
    if (!checked.knots) {
        std::vector<Diagnostic> errors;
        for (const std::string& problem : checked.problems) errors.emplace_back().message = problem;
        refuse(std::move(errors));
    }
    return *std::move(checked.knots);
}

/// The word of a refined curve's file, or its knots, must be what the coarse word becomes.
void check_fine_word(const SettledContour& contour, const InputPolygon& polygon, const FineKnots& fine_knots) {
    if (contour.fitting.fit != Fit::AsMeasured || (!polygon.word_letters && !polygon.knots)) return;
    const Knots fine = refined_knots(contour.coarse, contour.levels);
    const Alphabet& alphabet = fine.system().alphabet();
    const auto same = [&alphabet](Symbol symbol, const PlacedText& letter) {
        return (symbol == zero_interval ? std::string("0") : alphabet.name(symbol)) == letter.text;
    };
    const bool agrees = fine_knots
                            ? fine.word() == fine_knots->word
                            : !polygon.word_letters || std::ranges::equal(fine.word(), *polygon.word_letters, same);
    if (!agrees)
        refuse(fmt::format("the {} in {} {} not what the coarse word becomes after {} levels",
                           fine_knots ? "knots" : "word", polygon.source, fine_knots ? "are" : "is", contour.levels));
    if (!fine_knots) require_knots(polygon, fine, {});
}

void fit(SettledContour& contour, const InputPolygon& polygon, const PossibleSize& size, FitChoice choice) {
    const auto count = static_cast<std::size_t>(size.points);
    contour.fitting.measured = polygon.size();
    contour.fitting.points = count;
    if (count == polygon.size()) {
        contour.points = polygon.points;
    } else if (choice == FitChoice::Cut) {
        contour.fitting.fit = Fit::Cut;
        contour.points = cut(polygon.points, polygon.dimension, count);
    } else {
        ResampledPolygon result = resampled(polygon.points, polygon.dimension, contour.coarse.ends(), count);
        contour.fitting.fit = Fit::Resampled;
        contour.fitting.spacing = result.spacing;
        contour.points = std::move(result.points);
    }
}

/// The same curve, well conditioned.
void clamp(SettledContour& contour) {
    const Knots fine = refined_knots(contour.coarse, contour.levels);
    contour.points = clamped_points(fine, contour.dimension, contour.points);
    contour.coarse = clamped(contour.coarse);
    contour.fitting.clamped = true;
}

void refuse_options(const ContourOptions& options) {
    if (options.levels.value_or(0) > max_contour_levels) ask(fmt::format("at most {} levels", max_contour_levels));
    if (options.curve.repeat && !options.levels) ask("--repeat leaves the number of levels open", "give -n");
}

void refuse_points(const InputPolygon& polygon, const ContourOptions& options) {
    if (options.curve.rational || !polygon.weights.empty())
        refuse(polygon.source + " is to be taken apart: without weights", "leave out weights and --rational");
    for (const double coordinate : polygon.points)
        if (coordinate > largest_coordinate || coordinate < -largest_coordinate)
            refuse(polygon.source + " has a coordinate beyond 1e150");
}

} // namespace

Settled<SettledContour> settle_contour(const IntervalSystem& system, const InputPolygon& polygon,
                                       const ContourOptions& options) {
    assert(polygon.dimension >= 1 && polygon.size() >= 1);
    return settled([&] {
        refuse_options(options);
        const int degree = settled_degree(options.curve.degree, polygon, {});
        refuse_points(polygon, options);
        const FineKnots fine = fine_knots(system, polygon, options, degree);
        const IntervalSystem fine_system = fine ? fine->system : fixed_lengths(system, polygon);
        const CoarseWord coarse = settled_coarse(fine_system, polygon, options, fine, degree);
        const std::optional<int> levels =
            options.levels ? std::optional(static_cast<int>(*options.levels)) : std::optional<int>();
        const PossibleSize size =
            chosen_size(possible_sizes(fine_system.rules(), coarse, levels, polygon.size()), options, polygon);
        Knots knots = coarse_knots(fine_system, polygon, coarse, size);
        if (size.points > options.max_points)
            refuse(fmt::format("{} points are more than {}", size.points, options.max_points));
        SettledContour contour{std::move(knots),         size.levels, polygon.dimension, {}, {}, polygon.columns,
                               base_name(polygon.source)};
        fit(contour, polygon, size, options.fit);
        check_fine_word(contour, polygon, fine);
        const bool is_clamped = fine && has_clamped_ends(*fine, degree);
        if (coarse.ends == PolygonEnds::Open && !options.unclamped && !is_clamped) clamp(contour);
        return contour;
    });
}

} // namespace internode
