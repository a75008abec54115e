// SPDX-License-Identifier: MIT

#include "internode/input/settled_grid.h"

#include "internode/input/file_lengths.h"
#include "internode/input/refuse.h"
#include "internode/input/said_word.h"

#include <fmt/format.h>

namespace internode {

namespace {

/// One direction while it is being settled.
struct Side {
    char name; ///< 'u' or 'v'
    const GridSideOptions& options;
    const InputPolygon& input;
    std::size_t points; ///< that the grid has along it

    [[nodiscard]] std::string before() const { return fmt::format("along {}: ", name); }
};

Wording wording_of(const Side& side) {
    return {.option = fmt::format("--word-{}", side.name),
            .thing = "the grid's",
            .before = fmt::format("along {} ", side.name),
            .after = fmt::format(" along {}", side.name),
            .degree_hint = "give -d DU,DV, or \"degree\" in the grid's JSON"};
}

Ends settled_ends(const Side& side, const SaidWord& word) {
    const bool circular = says_circular(word);
    if (side.input.closed && !*side.input.closed && circular)
        refuse(fmt::format("along {} {} is circular: `( … )`, but \"closed\" is false in {}", side.name, word.origin,
                           side.input.source));
    return side.input.closed.value_or(circular) ? Ends::Circular : Ends::Open;
}

/// The letters that the points need: as they are, or repeated and cut.
Word fitted_word(const Side& side, const SaidWord& said, int degree, Ends ends, bool repeat) {
    const std::size_t needed = side.points + (ends == Ends::Open ? static_cast<std::size_t>(degree) : 0);
    const Word& word = said.axiom.word;
    if (word.size() == needed) return word;
    std::string what = fmt::format("along {} {} points of degree {} need a word of {} letters, but {} has {}",
                                   side.name, side.points, degree, needed, said.origin, word.size());
    if (!repeat) refuse(std::move(what), "--repeat repeats the letters to fit the points");
    if (word.size() > needed) refuse(std::move(what));
    return repeated(word, needed);
}

Knots checked(const Side& side, const IntervalSystem& system, KnotsData data) {
    CheckedKnots checked = make_knots(system, std::move(data));
    if (!checked.knots) refuse_all(side.input.source, side.before(), checked.problems);
    return *std::move(checked.knots);
}

/// Knots that the file says leave nothing to the caller.
Knots knots_of_file(const Side& side, const IntervalSystem& system, int degree) {
    if (!side.options.word.empty())
        refuse(fmt::format("the knots of {} along {} leave nothing to --word-{}", side.input.source, side.name,
                           side.name));
    const Ends ends = side.input.closed.value_or(false) ? Ends::Circular : Ends::Open;
    KnotWord said = word_of_knots(system, side.input, {side.points, degree, ends, side.before()});
    return checked(side, said.system, {degree, ends, std::move(said.word), std::move(said.origin)});
}

Knots settled_knots(const Side& side, const IntervalSystem& unscaled, bool repeat) {
    const IntervalSystem system = fixed_lengths(unscaled, side.input);
    const Wording wording = wording_of(side);
    const int degree = settled_degree(side.options.degree, side.input, wording);
    const bool has_word = side.input.word_text || side.input.word_letters;
    if (side.input.knots && !has_word) return knots_of_file(side, system, degree);
    const SaidWord said = settled_word(system, side.options.word, side.input, side.points, wording);
    const Ends ends = settled_ends(side, said);
    Number origin = file_origin(system, side.input, {side.points, degree, ends, side.before()});
    Knots knots =
        checked(side, system, {degree, ends, fitted_word(side, said, degree, ends, repeat), std::move(origin)});
    if (side.options.word.empty()) require_knots(side.input, knots, side.before());
    return knots;
}

} // namespace

Settled<Grid> settle_grid(const std::array<IntervalSystem, 2>& systems, InputGrid input, const GridOptions& options) {
    assert(input.rows >= 1 && input.columns >= 1);
    return settled([&] {
        const Side u{'u', options.sides[0], input.sides[0], input.rows};
        const Side v{'v', options.sides[1], input.sides[1], input.columns};
        GridData data{settled_knots(u, systems[0], options.repeat), settled_knots(v, systems[1], options.repeat),
                      input.dimension, input.rational, std::move(input.points)};
        CheckedGrid checked = make_grid(std::move(data));
        if (!checked.grid) refuse_all(input.source, {}, checked.problems);
        return *std::move(checked.grid);
    });
}

} // namespace internode
