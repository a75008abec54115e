// SPDX-License-Identifier: MIT
//
// Four checks run in turn, each of which takes those before it for granted; the first that complains ends it. Then the
// lengths between knots become letters: of a symbol for each distinct length, or of the grammar's own symbols at the
// one scale that fits.

#include "internode/curve/knot_vector.h"

#include "internode/curve/length_fit.h"
#include "internode/grammar/lexing/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

namespace internode {

namespace {

using Problems = std::vector<std::string>;

constexpr std::size_t listed_problems = 5; // problems of a kind: enough to see a pattern

std::size_t degree_of(const KnotVector& vector) {
    return static_cast<std::size_t>(vector.degree);
}

/// Whether the first and the last knot of an open curve are left out.
bool is_short(const KnotVector& vector) {
    return vector.ends == Ends::Open && vector.knots.size() + 1 == vector.points + degree_of(vector);
}

Problems count_problems(const KnotVector& vector) {
    const std::size_t given = vector.knots.size();
    const std::size_t n = vector.points;
    const std::size_t d = degree_of(vector);
    if (vector.ends == Ends::Circular) {
        if (given == n + 1) return {};
        return {fmt::format("a closed curve with {} points needs {} knots, one period from the first knot to its "
                            "return, not {}",
                            n, n + 1, given)};
    }
    if (n < d + 1) return {fmt::format("an open curve of degree {} needs at least {} points, not {}", d, d + 1, n)};
    if (given == n + d + 1 || is_short(vector)) return {};
    return {fmt::format("an open curve of degree {} with {} points needs {} knots, or {} without the first and the "
                        "last, not {}",
                        d, n, n + d + 1, n + d - 1, given)};
}

Problems order_problems(const IntervalSystem& system, const KnotVector& vector) {
    Problems problems;
    for (std::size_t i = 1; i < vector.knots.size() && problems.size() < listed_problems; ++i)
        if (vector.knots[i] < vector.knots[i - 1])
            problems.push_back(fmt::format("knot {} is {}, less than knot {}, which is {}: knots must not decrease",
                                           i + 1, exact_text(vector.knots[i], system), i,
                                           exact_text(vector.knots[i - 1], system)));
    return problems;
}

/// Knots first … last, counted from 0, are one knot.
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};

std::vector<Run> runs(const std::vector<Number>& knots) {
    std::vector<Run> result;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (i > 0 && knots[i] == knots[i - 1])
            result.back().last = i;
        else
            result.push_back({i, i});
    }
    return result;
}

Problems multiplicity_problems(const IntervalSystem& system, const KnotVector& vector) {
    const std::vector<Run> all = runs(vector.knots);
    if (all.size() == 1) return {"all knots are equal: no interval has a length"};
    const std::size_t d = degree_of(vector);
    const bool closed = vector.ends == Ends::Circular;
    const std::size_t at_end = closed || is_short(vector) ? d : d + 1;
    Problems problems;
    for (const Run& run : all) {
        const bool ends_it = run.first == 0 || run.last + 1 == vector.knots.size();
        std::size_t multiplicity = run.last - run.first + 1;
        if (closed && run.first == 0) continue; // the last knot is the first again: counted there
        if (closed && ends_it) multiplicity += all.front().last;
        if (multiplicity <= (ends_it ? at_end : d) || problems.size() == listed_problems) continue;
        problems.push_back(
            fmt::format("knot {} (knots {} to {}) has multiplicity {}: at most {} {} a curve of degree {}",
                        exact_text(vector.knots[run.first], system), run.first + 1, run.last + 1, multiplicity,
                        ends_it ? at_end : d, ends_it && !closed ? "end" : "fit inside", d));
    }
    return problems;
}

Problems domain_problems(const IntervalSystem& system, const KnotVector& vector) {
    if (vector.ends == Ends::Circular) return {};
    const std::size_t shift = is_short(vector) ? 1 : 0; // knot 0 is t_1
    const std::size_t first = degree_of(vector) - shift;
    const std::size_t last = vector.points - shift;
    assert(first < last && last < vector.knots.size());
    Problems problems;
    const auto refuse = [&](std::string_view which, std::size_t knot) {
        problems.push_back(fmt::format("the domain goes from knot {} to knot {}, and its {} interval is empty: knots "
                                       "{} and {} are both {}",
                                       first + 1, last + 1, which, knot + 1, knot + 2,
                                       exact_text(vector.knots[knot], system)));
    };
    if (vector.knots[first] == vector.knots[first + 1]) refuse("first", first);
    if (last > first + 1 && vector.knots[last - 1] == vector.knots[last]) refuse("last", last - 1);
    return problems;
}

/// The knot where the domain begins.
const Number& origin_of(const KnotVector& vector) {
    if (vector.ends == Ends::Circular) return vector.knots.front();
    return vector.knots[degree_of(vector) - (is_short(vector) ? 1 : 0)];
}

/// The length of each letter.
std::vector<Number> letter_lengths(const KnotVector& vector) {
    assert(!vector.knots.empty());
    std::vector<Number> lengths;
    lengths.reserve(vector.knots.size() + 1);
    if (is_short(vector)) lengths.emplace_back();
    for (std::size_t i = 1; i < vector.knots.size(); ++i) lengths.push_back(vector.knots[i] - vector.knots[i - 1]);
    if (is_short(vector)) lengths.emplace_back();
    return lengths;
}

/// A symbol for each distinct length, A1, A2, …; the grammar's own name for a single one.
FittedKnots copied(const IntervalSystem& system, const std::vector<Number>& lengths) {
    assert(system.alphabet().size() == 1 && system.field().degree() == 1);
    KnotWord result{system, {}, {}};
    std::map<Number, Symbol> symbols;
    std::vector<Rational> distinct;
    result.word.reserve(lengths.size());
    for (const Number& length : lengths) {
        if (length.sign() == 0) {
            result.word.push_back(zero_interval);
            continue;
        }
        const auto [place, is_new] = symbols.try_emplace(length, to_symbol(distinct.size()));
        if (is_new) distinct.push_back(length.coefficients(system.field()).front());
        result.word.push_back(place->second);
    }
    if (distinct.size() > max_symbols)
        return {std::nullopt,
                {fmt::format("{} intervals of different length, more than the {} symbols that a grammar may have",
                             distinct.size(), max_symbols)}};
    const std::string& name = system.alphabet().names().front();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < distinct.size(); ++i)
        names.push_back(distinct.size() == 1 ? name : name.front() + std::to_string(i + 1));
    result.system = one_symbol_a_length(system, names, distinct);
    return {std::move(result), {}};
}

FittedKnots labelled(const IntervalSystem& system, const KnotVector& vector, const std::vector<Number>& lengths) {
    ScaledSystem scaled = fit_scale(system, lengths, vector.fixed);
    if (!scaled.system) return {std::nullopt, {std::move(scaled.problem)}};
    const LengthTable table(*scaled.system);
    FittedKnots result;
    Word word;
    std::map<Number, Symbol> refused; // each length is complained about once
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const std::vector<Symbol>& symbols = table.symbols(lengths[i]);
        if (symbols.size() == 1) {
            word.push_back(symbols.front());
        } else if (refused.size() < listed_problems && refused.try_emplace(lengths[i], zero_interval).second) {
            const std::size_t knot = i + (is_short(vector) ? 0 : 1);
            result.problems.push_back(fmt::format("the interval from knot {} to knot {} is {}: {}", knot, knot + 1,
                                                  exact_text(lengths[i], system), table.complaint(lengths[i])));
        }
    }
    assert(!result.problems.empty() || word.size() == lengths.size());
    if (result.problems.empty()) result.fitted = KnotWord{*std::move(scaled.system), std::move(word), {}};
    return result;
}

} // namespace

FittedKnots fit_knots(const IntervalSystem& system, const KnotVector& knots) {
    if (knots.degree < 1) throw std::invalid_argument("a knot vector needs a degree of at least 1");
    using Check = Problems (*)(const IntervalSystem&, const KnotVector&);
    constexpr Check count = [](const IntervalSystem&, const KnotVector& vector) { return count_problems(vector); };
    for (const Check check : {count, Check{order_problems}, Check{multiplicity_problems}, Check{domain_problems}})
        if (Problems problems = check(system, knots); !problems.empty()) return {std::nullopt, std::move(problems)};
    const std::vector<Number> lengths = letter_lengths(knots);
    const bool says_any_length =
        system.alphabet().size() == 1 && system.grammar().lengths.empty() && knots.fixed.empty();
    FittedKnots result = says_any_length ? copied(system, lengths) : labelled(system, knots, lengths);
    if (result.fitted) result.fitted->origin = origin_of(knots);
    return result;
}

} // namespace internode
