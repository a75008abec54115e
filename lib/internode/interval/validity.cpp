// SPDX-License-Identifier: MIT
//
// Classes, their radii and the order of these come first, and the verdict follows from them alone: valid is what
// nothing refutes (interval/reasons.h). Only then come lengths, exactly where the field and the classes are small
// enough, else between bounds; a declared length can still refute the system.

#include "internode/interval/validity.h"

#include "internode/interval/enclosed_lengths.h"
#include "internode/interval/length_scales.h"
#include "internode/interval/reasons.h"
#include "internode/interval/system_maker.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace internode {

namespace {

/// Products of integers that exact lengths may cost: some seconds, reached by classes of 200 symbols only.
constexpr std::size_t exact_products = 60'000'000;

bool is_unordered(std::partial_ordering order) {
    return order == std::partial_ordering::unordered;
}

/// What validate() knows once the classes are ordered.
struct Analysis {
    const IntervalGrammar& grammar;
    ClassGraph graph;
    std::vector<ClassRadius> radii;
    LargestRadius largest;
    bool decided = false; ///< nothing is unordered
};

std::vector<SymbolClass> describe_classes(const Analysis& analysis) {
    std::vector<SymbolClass> result;
    for (std::size_t i = 0; i < analysis.radii.size(); ++i) {
        const IntervalClass& one = analysis.graph.classes[i];
        SymbolClass& described = result.emplace_back();
        for (const std::uint32_t member : one.members) described.symbols.push_back(to_symbol(member));
        described.final = one.final;
        if (analysis.largest.order[i] == std::partial_ordering::less)
            described.basic = false;
        else if (analysis.decided)
            described.basic = true;
        described.period = one.period;
        described.ratio = analysis.radii[i].value;
    }
    std::ranges::sort(result, {}, [](const SymbolClass& one) { return one.symbols.front(); });
    return result;
}

/// The ratio of the largest class; without an order, at least that of one and at most that of all that may be it.
Quantity system_ratio(const Analysis& analysis) {
    if (analysis.decided) return analysis.radii[analysis.largest.index].value;
    Enclosure bounds = analysis.radii[analysis.largest.index].value.bounds;
    for (std::size_t i = 0; i < analysis.radii.size(); ++i)
        if (is_unordered(analysis.largest.order[i]))
            bounds.upper = std::max(bounds.upper, analysis.radii[i].value.bounds.upper);
    return enclosed_quantity(bounds);
}

/// The least common multiple, or the largest number when it does not fit.
std::size_t common_period(const std::vector<SymbolClass>& classes) {
    std::size_t period = 1;
    for (const SymbolClass& one : classes) {
        if (!one.basic.value_or(false) || one.period == 0) continue;
        const std::size_t factor = one.period / std::gcd(period, one.period);
        if (period > std::numeric_limits<std::size_t>::max() / factor) return std::numeric_limits<std::size_t>::max();
        period *= factor;
    }
    return period;
}

std::vector<std::string> theorems(const ClassGraph& graph) {
    // One class and a ratio above 1: some rule has two letters, so 3.7 holds.
    if (graph.classes.size() > 1) return {"criterion"};
    std::vector<std::string> result{"3.7"};
    const IntervalClass& whole = graph.classes.front();
    const auto names_itself = [&](std::uint32_t i) {
        return std::ranges::any_of(graph.matrix[i], [&](const auto& entry) { return entry.first == i; });
    };
    if (whole.members.size() >= 2 && std::ranges::any_of(whole.members, names_itself)) result.emplace_back("3.8");
    return result;
}

/// Whether ratio and lengths can be had in a field within the limits.
bool is_exact(const Analysis& analysis, const ValidityLimits& limits) {
    const ClassRadius& radius = analysis.radii[analysis.largest.index];
    assert(!radius.value.exact || radius.field);
    if (!analysis.decided || !radius.value.exact) return false;
    std::size_t products = 0;
    for (const IntervalClass& one : analysis.graph.classes) {
        const std::size_t size = one.block.size();
        if (size == 1) continue;
        if (size > limits.exact_class) return false;
        std::size_t entries = 0;
        for (const SparseRow& row : one.block) entries += row.size();
        products += size * size * size + (one.final ? 1 : radius.field->degree()) * size * entries;
        if (products > exact_products) return false;
    }
    return true;
}

std::vector<Quantity> exact_quantities(const std::vector<Number>& numbers) {
    std::vector<Quantity> result;
    result.reserve(numbers.size());
    for (const Number& number : numbers) result.push_back(exact_quantity(number));
    return result;
}

void solve_exactly(const Analysis& analysis, Verdict& verdict) {
    assert(verdict.field);
    const ExactSystem system{analysis.graph, *verdict.field};
    const std::string generator = SystemMaker::generator_name(*verdict.field);
    std::vector<FixedLength> declared;
    for (const LengthDeclaration& one : analysis.grammar.lengths) declared.push_back({one.symbol, one.length});
    ScaledLengths scaled = scale_lengths(system, unit_lengths(system), declared, analysis.grammar.alphabet, generator);
    verdict.frequencies = exact_quantities(frequencies(system, analysis.grammar.axiom));
    for (LengthConflict& conflict : scaled.conflicts)
        verdict.reasons.push_back({ReasonCode::LengthsDisagree, {conflict.symbol}, std::move(conflict.message)});
    if (!verdict.reasons.empty()) {
        verdict.decision = Decision::Invalid;
        return;
    }
    verdict.lengths = exact_quantities(scaled.lengths);
    verdict.system = SystemMaker::make(analysis.grammar, *verdict.field, verdict.field->generator(),
                                       std::move(scaled.lengths), verdict.period);
}

void solve_by_bounds(const Analysis& analysis, Verdict& verdict) {
    verdict.frequencies = enclosed_frequencies(analysis.graph);
    EnclosedLengths enclosed = enclosed_lengths(analysis.graph, analysis.grammar);
    for (EnclosedConflict& conflict : enclosed.conflicts) {
        verdict.reasons.push_back({ReasonCode::LengthsDisagree, {conflict.symbol}, std::move(conflict.message)});
        if (conflict.certain)
            verdict.decision = Decision::Invalid;
        else if (verdict.decision == Decision::Valid)
            verdict.decision = Decision::Undecided;
    }
    if (verdict.decision == Decision::Valid) verdict.lengths = std::move(enclosed.lengths);
}

void decide(const Analysis& analysis, Verdict& verdict) {
    const Diagnosis diagnosis{analysis.grammar.alphabet, analysis.graph, analysis.radii, analysis.largest};
    verdict.reasons = refutations(diagnosis);
    if (!verdict.reasons.empty()) {
        verdict.decision = Decision::Invalid;
    } else if (!analysis.decided) {
        verdict.decision = Decision::Undecided;
        verdict.reasons = overlaps(diagnosis);
    } else {
        verdict.decision = Decision::Valid;
    }
}

Verdict nothing_occurs() {
    Verdict verdict;
    verdict.decision = Decision::Invalid;
    verdict.reasons.push_back({ReasonCode::RatioOne, {}, "no symbol occurs: there is nothing that could split"});
    verdict.ratio = exact_quantity(Number(0));
    return verdict;
}

} // namespace

std::string_view to_string(ReasonCode code) {
    switch (code) {
    case ReasonCode::NeverSplits:
        return "never-splits";
    case ReasonCode::FinalTooSmall:
        return "final-too-small";
    case ReasonCode::FinalDisagree:
        return "final-disagree";
    case ReasonCode::BasicNotFinal:
        return "basic-not-final";
    case ReasonCode::RatioOne:
        return "ratio-one";
    case ReasonCode::LengthsDisagree:
        return "lengths-disagree";
    case ReasonCode::Overlap:
        return "overlap";
    }
    assert(false);
    return "";
}

Verdict validate(const IntervalGrammar& grammar, const ValidityLimits& limits) {
    Analysis analysis{grammar, class_graph(grammar), {}, {}, false};
    if (analysis.graph.classes.empty()) {
        Verdict verdict = nothing_occurs();
        verdict.occurs.assign(grammar.alphabet.size(), false);
        return verdict;
    }
    analysis.radii = class_radii(analysis.graph, {limits.exact_class, limits.field_degree});
    analysis.largest = largest_radius(analysis.radii);
    analysis.decided = std::ranges::none_of(analysis.largest.order, is_unordered);

    Verdict verdict;
    for (const std::uint32_t index : analysis.graph.class_of) verdict.occurs.push_back(index != no_class);
    verdict.classes = describe_classes(analysis);
    verdict.ratio = system_ratio(analysis);
    verdict.period = common_period(verdict.classes);
    for (const SymbolClass& one : verdict.classes) verdict.free_lengths += one.final ? 1U : 0U;
    decide(analysis, verdict);

    const bool valid = verdict.decision == Decision::Valid;
    verdict.exact = valid ? is_exact(analysis, limits) : verdict.ratio.exact.has_value();
    if (verdict.exact) {
        verdict.field = analysis.radii[analysis.largest.index].field;
        verdict.pisot = analysis.radii[analysis.largest.index].pisot;
    }
    if (valid && verdict.exact) solve_exactly(analysis, verdict);
    if (valid && !verdict.exact) solve_by_bounds(analysis, verdict);
    if (verdict.decision == Decision::Valid) verdict.theorems = theorems(analysis.graph);
    return verdict;
}

} // namespace internode
