// SPDX-License-Identifier: MIT

#include "cli/intervals/contour.h"

#include "cli/shell/exit_code.h"
#include "cli/shell/load.h"
#include "cli/intervals/polygon.h"
#include "internode/curve/clamping.h"
#include "internode/curve/refinement.h"
#include "internode/curve/reverse/possible_size.h"
#include "internode/curve/reverse/pyramid.h"
#include "internode/io/polygon.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

/// Beyond, a coarse word of one letter would be rewritten for ever.
constexpr std::uint64_t max_levels = 100'000;

struct SaidWord {
    Axiom axiom;
    bool says_ends = false;
};

SaidWord coarse_word(const IntervalSystem& system, const PolygonOptions& options) {
    if (!options.word.empty()) {
        ParsedWord word = load_word(options.word, system.alphabet());
        return {std::move(word.axiom), word.says_ends};
    }
    if (system.grammar().axiom) return {*system.grammar().axiom, true};
    throw failure(ExitCode::Refused, "no word for the coarse polygon",
                  fmt::format("name its knot intervals, for example --word '{}' --repeat",
                              to_string(Word{to_symbol(0)}, system.alphabet())));
}

PolygonEnds contour_ends(const PolygonOptions& options, const InputPolygon& polygon, const SaidWord& said) {
    const bool circular = said.says_ends && said.axiom.ends == Ends::Circular;
    const bool closed =
        options.ends == EndsOption::Closed || (options.ends == EndsOption::Unsaid && polygon.closed.value_or(circular));
    if (polygon.closed && *polygon.closed != closed)
        throw failure(ExitCode::Refused, fmt::format("the ends asked for disagree with \"closed\": {} of {}",
                                                     *polygon.closed, polygon.source));
    if (circular && !closed)
        throw failure(ExitCode::Refused, "the coarse word is circular: `( … )`, but the ends are open");
    if (closed) return PolygonEnds::Closed;
    return options.ends == EndsOption::Clamped ? PolygonEnds::Clamped : PolygonEnds::Open;
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
PossibleSize chosen_size(const PossibleSizes& sizes, const ReverseOptions& options, const InputPolygon& polygon) {
    const std::uint64_t points = polygon.size();
    if (sizes.exact()) return *sizes.below;
    const bool cut = options.fit == FitOption::Cut;
    if (options.fit == FitOption::Refuse || (cut && !sizes.below) || (!sizes.below && !sizes.above))
        throw failure(ExitCode::Refused,
                      fmt::format("{} has {} points, which no refinement of the coarse word gives; the nearest numbers "
                                  "are {}",
                                  polygon.source, points, possible_text(sizes)),
                      "--resample to the nearest, --cut to the one below, another --word or -n");
    if (!sizes.above) return *sizes.below;
    if (!sizes.below) return *sizes.above;
    return cut || points - sizes.below->points <= sizes.above->points - points ? *sizes.below : *sizes.above;
}

/// With the lengths that a refined curve's file says: those of the coarse polygon are ρ^levels times as long.
IntervalSystem scaled_system(const IntervalSystem& system, const InputPolygon& polygon, int levels) {
    if (polygon.lengths.empty()) return system;
    const Number scale = pow(system.ratio(), levels);
    std::vector<FixedLength> lengths;
    for (const InputLength& length : polygon.lengths) {
        const auto symbol = system.alphabet().find(length.symbol.text);
        if (!symbol || length.coefficients.size() > system.field().degree())
            throw failure(ExitCode::Refused, fmt::format("{}: the length of `{}` does not belong to the grammar",
                                                         polygon.source, length.symbol.text));
        lengths.push_back({*symbol, Number(system.field(), length.coefficients) * scale});
    }
    FixedLengths fixed = with_lengths(system, lengths);
    if (!fixed.system) throw failure(ExitCode::Refused, polygon.source + ": " + fixed.conflicts.front().message);
    return *std::move(fixed.system);
}

Knots checked_knots(const IntervalSystem& system, const ReverseOptions& options, const InputPolygon& polygon,
                    const CoarseWord& coarse, const PossibleSize& size) {
    const Ends ends = coarse.ends == PolygonEnds::Closed ? Ends::Circular : Ends::Open;
    CheckedKnots checked = make_knots(scaled_system(system, polygon, size.levels), {coarse.degree, ends, size.word});
    if (!checked.knots) {
        std::string text;
        for (const std::string& problem : checked.problems) text += fmt::format("error: {}\n", printable(problem));
        throw Failure(ExitCode::Refused, text);
    }
    if (size.points > options.polygon.max_points)
        throw failure(ExitCode::Refused,
                      fmt::format("{} points are more than {}", size.points, options.polygon.max_points));
    return *std::move(checked.knots);
}

/// The word of a refined curve's file must be what the coarse word becomes.
void check_fine_word(const LoadedContour& contour, const InputPolygon& polygon) {
    if (!polygon.word_letters || contour.fitting.fit != Fit::AsMeasured) return;
    const Knots fine = refined_knots(contour.coarse, contour.levels);
    const Alphabet& alphabet = fine.system().alphabet();
    const std::vector<PlacedText>& letters = *polygon.word_letters;
    const auto same = [&alphabet](Symbol symbol, const PlacedText& letter) {
        return alphabet.name(symbol) == letter.text;
    };
    if (!std::ranges::equal(fine.word(), letters, same))
        throw failure(ExitCode::Refused, fmt::format("the word in {} is not what the coarse word becomes after {} "
                                                     "levels",
                                                     polygon.source, contour.levels));
}

void fit(LoadedContour& contour, const InputPolygon& polygon, const PossibleSize& size, FitOption option) {
    const auto count = static_cast<std::size_t>(size.points);
    contour.fitting.measured = polygon.size();
    contour.fitting.points = count;
    if (count == polygon.size()) {
        contour.points = polygon.points;
    } else if (option == FitOption::Cut) {
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
void clamp(LoadedContour& contour) {
    const Knots fine = refined_knots(contour.coarse, contour.levels);
    contour.points = clamped_points(fine, contour.dimension, contour.points);
    contour.coarse = clamped(contour.coarse);
    contour.fitting.clamped = true;
}

InputPolygon read_contour(const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    ParsedPolygon parsed = read_polygon(input.text, input.source);
    if (!parsed.polygon) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    const InputPolygon& polygon = *parsed.polygon;
    if (!options.degree && !polygon.degree)
        throw failure(ExitCode::Usage, "no degree", "give -d, or \"degree\" in the polygon's JSON");
    if (options.degree && polygon.degree && static_cast<std::size_t>(*options.degree) != *polygon.degree)
        throw failure(ExitCode::Refused, fmt::format("-d {} disagrees with \"degree\": {} of {}", *options.degree,
                                                     *polygon.degree, polygon.source));
    if (options.rational || !polygon.weights.empty() || polygon.knots)
        throw failure(ExitCode::Refused,
                      polygon.source + " is to be taken apart: without weights, and by the word of its coarse polygon",
                      "leave out weights, knots and --rational");
    for (const double coordinate : polygon.points)
        if (coordinate > largest_coordinate || coordinate < -largest_coordinate)
            throw failure(ExitCode::Refused, polygon.source + " has a coordinate beyond 1e150");
    return *std::move(parsed.polygon);
}

} // namespace

LoadedContour load_contour(const IntervalSystem& system, const ReverseOptions& options) {
    if (options.levels.value_or(0) > max_levels)
        throw failure(ExitCode::Usage, fmt::format("at most {} levels", max_levels));
    if (options.polygon.repeat && !options.levels)
        throw failure(ExitCode::Usage, "--repeat leaves the number of levels open", "give -n");
    const InputPolygon polygon = read_contour(options.polygon);
    const SaidWord said = coarse_word(system, options.polygon);
    CoarseWord coarse;
    coarse.letters = said.axiom.word;
    coarse.repeat = options.polygon.repeat;
    coarse.ends = contour_ends(options.polygon, polygon, said);
    coarse.degree = options.polygon.degree ? *options.polygon.degree : static_cast<int>(*polygon.degree);
    if (coarse.degree < 1 || coarse.degree > max_degree)
        throw failure(ExitCode::Refused, fmt::format("\"degree\": {} of {} is not between 1 and {}", coarse.degree,
                                                     polygon.source, max_degree));
    const std::optional<int> levels =
        options.levels ? std::optional(static_cast<int>(*options.levels)) : std::optional<int>();
    const PossibleSize size =
        chosen_size(possible_sizes(system.rules(), coarse, levels, polygon.size()), options, polygon);
    const auto slash = polygon.source.find_last_of('/');
    LoadedContour contour{checked_knots(system, options, polygon, coarse, size),
                          size.levels,
                          polygon.dimension,
                          {},
                          {},
                          polygon.columns,
                          slash == std::string::npos ? polygon.source : polygon.source.substr(slash + 1)};
    fit(contour, polygon, size, options.fit);
    check_fine_word(contour, polygon);
    if (coarse.ends == PolygonEnds::Open && !options.unclamped) clamp(contour);
    return contour;
}

} // namespace internode::cli
