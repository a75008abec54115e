// SPDX-License-Identifier: MIT
//
// The stages of the long way, one behind the other: text, grammar, system, word, curve. Each stage that says what is
// wrong as a value says it here as the text of an exception.

#include "internode/refine.h"

#include "internode/curve/refinement.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/parse.h"
#include "internode/interval/validity.h"
#include "internode/refine_points.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <cassert>
#include <stdexcept>
#include <variant>

namespace internode {

namespace {

std::string_view text_of(std::string_view grammar) {
    if (!grammar.starts_with('@')) return grammar;
    const BundledGrammar* bundled = find_bundled_grammar(grammar.substr(1));
    if (bundled == nullptr) throw std::invalid_argument(fmt::format("no bundled grammar `{}`", printable(grammar)));
    return bundled->text;
}

std::string_view source_of(std::string_view grammar) {
    return grammar.starts_with('@') ? grammar : std::string_view("<grammar>");
}

Grammar grammar_of(const RefineRequest& request) {
    Parsed<Grammar> parsed = parse(request.text, request.source);
    if (!parsed.grammar) throw std::invalid_argument(to_string(parsed.errors));
    return *std::move(parsed.grammar);
}

IntervalSystem system_of(const IntervalGrammar& grammar) {
    const Verdict verdict = validate(grammar);
    if (verdict.system) return *verdict.system;
    std::string reasons = verdict.decision == Decision::Invalid ? "the grammar is not a valid interval system"
                                                                : "the grammar is too large for exact weights";
    for (const Reason& reason : verdict.reasons) reasons += "\n  " + printable(reason.message);
    throw std::invalid_argument(reasons);
}

/// A word that goes round has no ends to leave open.
void refuse_ring(const Axiom& said, Ends ends) {
    if (said.ends == Ends::Circular && ends != Ends::Circular)
        throw std::invalid_argument("the word is circular: `( … )`, but the ends are open");
}

/// The letters of options.word, or of a grammar of one symbol; at least one.
Word letters_of(const IntervalSystem& system, const RefineOptions& options) {
    if (options.word.empty()) {
        if (system.alphabet().size() == 1) return {to_symbol(0)};
        throw std::invalid_argument(fmt::format("no word: name the knot intervals, for example .word = \"{}\"",
                                                to_string(Word{to_symbol(0)}, system.alphabet())));
    }
    const ParsedWord parsed = parse_word(options.word, system.alphabet(), "<word>");
    if (!parsed.errors.empty()) throw std::invalid_argument(to_string(parsed.errors));
    refuse_ring(parsed.axiom, options.ends);
    return parsed.axiom.word;
}

/// The letters, repeated and cut to the intervals of so many points.
Word fitted_word(const Word& letters, std::size_t points, const RefineOptions& options) {
    assert(!letters.empty());
    const auto degree = static_cast<std::size_t>(options.degree);
    const bool circular = options.ends == Ends::Circular;
    if (!circular && points <= degree)
        throw std::invalid_argument(
            fmt::format("an open curve of degree {} needs at least {} points, not {}", degree, degree + 1, points));
    const std::size_t needed = circular ? points : (options.clamped ? points - degree : points + degree);
    if (letters.size() > needed)
        throw std::invalid_argument(fmt::format("the word has {} letters, more than the {} that {} points need",
                                                letters.size(), needed, points));
    const Word word = repeated(letters, needed);
    return circular || !options.clamped ? word : clamped(word, options.degree);
}

/// The word of the whole curve.
Word word_of(const IntervalSystem& system, std::size_t points, const RefineOptions& options) {
    const std::optional<Axiom>& axiom = system.grammar().axiom;
    if (!options.word.empty() || !axiom) return fitted_word(letters_of(system, options), points, options);
    refuse_ring(*axiom, options.ends);
    return axiom->word;
}

/// The curve of a polygon before its first step; `points` are whole rows.
Curve curve_of(const IntervalGrammar& grammar, std::span<const double> points, std::size_t dimension,
               const RefineOptions& options) {
    if (options.degree < 1 || options.degree > max_degree)
        throw std::invalid_argument(fmt::format("the degree {} is not between 1 and {}", options.degree, max_degree));
    const IntervalSystem system = system_of(grammar);
    CurveData data{options.degree, options.ends, {}, dimension, {points.begin(), points.end()}};
    data.word = word_of(system, points.size() / dimension, options);
    const CheckedCurve checked = make_curve(system, std::move(data));
    if (checked.curve) return *checked.curve;
    std::string problems;
    for (const std::string& problem : checked.problems) problems += problems.empty() ? problem : "\n" + problem;
    throw std::invalid_argument(problems);
}

std::vector<double> refined(const IntervalGrammar& grammar, const RefineRequest& request) {
    const RefineOptions& options = request.options;
    const Curve curve = curve_of(grammar, request.points, request.dimension, options);
    const RefinementSize size = refined_size(curve, static_cast<std::uint64_t>(request.steps), options.max_points);
    if (size.exceeded) throw too_many_points(request);
    return refine(curve, request.steps, options.apply).points();
}

void require_rows(std::span<const double> points, std::size_t dimension) {
    if (dimension == 0 || points.empty() || points.size() % dimension != 0)
        throw std::invalid_argument(
            fmt::format("{} coordinates are not whole points of {} coordinates", points.size(), dimension));
}

} // namespace

Curve curve_from(std::string_view grammar, std::span<const double> points, std::size_t dimension,
                 const RefineOptions& options) {
    require_rows(points, dimension);
    const ParsedGrammar parsed = parse_grammar(text_of(grammar), source_of(grammar));
    if (!parsed.grammar) throw std::invalid_argument(to_string(parsed.errors));
    return curve_of(*parsed.grammar, points, dimension, options);
}

std::vector<double> refine(std::string_view grammar, std::span<const double> points, std::size_t dimension,
                           const RefineOptions& options, int steps) {
    require_rows(points, dimension);
    if (steps < 0) throw std::invalid_argument(fmt::format("{} steps: refinement goes forwards", steps));
    const RefineRequest request{text_of(grammar), source_of(grammar), points, dimension, options, steps};
    return std::visit([&](const auto& kind) { return refined(kind, request); }, grammar_of(request));
}

} // namespace internode
