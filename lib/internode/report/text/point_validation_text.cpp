// SPDX-License-Identifier: MIT

#include "internode/report/text/point_validation_text.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "internode/report/text/mask_facts_text.h"
#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <algorithm>

namespace internode {

namespace {

constexpr std::size_t listed_findings = 20;
constexpr std::size_t listed_contexts = 8;
constexpr std::size_t expression_columns = 60;

std::string item(const std::string& sentence) {
    return "  - " + wrapped(printable(sentence), 4) + "\n";
}

std::string plural(std::size_t count, const std::string& word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::string line_of(const SourcePlace& place, const GrammarSourceText& source) {
    if (place.bytes == 0) return "";
    const Diagnostic at = diagnostic_at(source.text, source.source, place, "", "");
    return "line " + std::to_string(at.line) + ": ";
}

std::string expression_text(const PointGrammar& grammar, const ArgumentPlace& where) {
    std::string text = print(expression_at(grammar, where), formals_at(grammar, where), grammar);
    if (text.size() > expression_columns) text = text.substr(0, expression_columns) + "...";
    return text;
}

std::string problems_text(const PointValidation& validation, const GrammarSourceText& source) {
    std::string text;
    for (const PointProblem& problem : validation.problems) {
        text += item(line_of(problem.place, source) + problem.message);
        if (!problem.hint.empty()) text += "    " + wrapped(printable(problem.hint), 4) + "\n";
    }
    return text;
}

std::string unsound_text(const PointValidation& validation, const PointGrammar& grammar,
                         const GrammarSourceText& source) {
    std::string text;
    std::size_t count = 0;
    for (const AffineFinding& finding : validation.affine) {
        if (is_sound(finding.verdict) || ++count > listed_findings) continue;
        text += item(line_of(finding.place, source) + place_text(grammar, finding.where) + ": in `" +
                     expression_text(grammar, finding.where) + "` " + finding_text(finding));
    }
    if (count > listed_findings) text += item("and " + std::to_string(count - listed_findings) + " more");
    if (validation.coverage && !validation.coverage->ends_complete)
        text += item("no rule fits some points inside the word, though rules elsewhere make several points of one");
    return text;
}

std::string affine_text(const PointValidation& validation) {
    const auto count = [&](AffineVerdict verdict) {
        return static_cast<std::size_t>(std::ranges::count(validation.affine, verdict, &AffineFinding::verdict));
    };
    if (validation.affine.empty()) return "none: no module has a point";
    std::string text = plural(count(AffineVerdict::Affine), "combination") + " of points with sum 1";
    if (const auto some = count(AffineVerdict::AffineForTheseConstants))
        text += "; " + std::to_string(some) + " with a sum that is 1 for these values of the constants only";
    if (const auto literal = count(AffineVerdict::MixesCoordinates))
        text += "; " + std::to_string(literal) + " with literal points or coordinates, which do not move with the rest";
    if (const auto wrong = count(AffineVerdict::SumIsNotOne))
        text += "; " + std::to_string(wrong) + " with another sum";
    if (const auto open = count(AffineVerdict::NotDecided)) text += "; " + std::to_string(open) + " not decided";
    return text;
}

std::string explored_text(const Coverage& coverage) {
    const std::string cycles = plural(static_cast<std::size_t>(coverage.cycles), "cycle");
    if (coverage.points == 0) return " (seen in " + cycles + " from the axiom)";
    return " (seen in " + cycles + " from 1 to " + std::to_string(coverage.points) + " points)";
}

std::string numbers_text(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (const std::size_t number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

std::string ends_text(const Coverage& coverage, const PointGrammar& grammar) {
    if (!coverage.ends_complete) return "not complete";
    if (grammar.ring && coverage.incomplete.empty()) return "none, a ring";
    if (coverage.incomplete.empty()) return "complete";
    return "complete for polygons of " + numbers_text(coverage.complete) + " points, not of " +
           numbers_text(coverage.incomplete);
}

std::string coverage_text(const Coverage& coverage, const PointGrammar& grammar) {
    const bool staying = !coverage.staying.empty();
    std::string text = labelled("coverage", std::string(staying ? "some points stay, where no rule fits"
                                                                : "no point stays for want of a rule") +
                                                explored_text(coverage));
    for (std::size_t i = 0; i < coverage.staying.size() && i < listed_contexts; ++i)
        text += labelled("", staying_text(coverage.staying[i], grammar));
    if (coverage.staying.size() > listed_contexts)
        text += labelled("", "and " + std::to_string(coverage.staying.size() - listed_contexts) + " more contexts");
    text += labelled("ends", ends_text(coverage, grammar));
    for (const std::uint32_t rule : coverage.unused)
        text += labelled("never applied", print(grammar.rules[rule], grammar));
    if (coverage.problem)
        text += labelled("derivation", (coverage.problem_points > 0
                                            ? "of " + plural(coverage.problem_points, "point") + " ends early: "
                                            : "of the axiom ends early: ") +
                                           printable(coverage.problem->message));
    return text;
}

std::string compilation_text(const CompilationFacts& facts, const GrammarSourceText& source) {
    if (facts.compiles) return labelled("compiles", "to an automaton with " + plural(facts.states, "state"));
    std::string text;
    for (const ExactStop& stop : facts.reasons)
        text += labelled(text.empty() ? "compiles" : "",
                         (text.empty() ? "no: " : "") + line_of(stop.place, source) + printable(stop.reason));
    return text.empty() ? labelled("compiles", "no") : text;
}

std::string twin_text(const IntervalTwin& twin) {
    std::string letters;
    for (std::size_t i = 0; i < twin.arity; ++i) letters += " A";
    std::string text =
        "`intervals A ->" + letters + "` at degree " + std::to_string(twin.degree) + " is the same automaton";
    if (twin.moved > 0) text += ", after a shift by " + plural(twin.moved, "new point");
    return text;
}

} // namespace

std::string place_text(const PointGrammar& grammar, const ArgumentPlace& where) {
    const std::string module = ", module " + std::to_string(where.module + 1);
    if (where.part == GrammarPart::Axiom) return "the axiom" + module;
    if (where.part == GrammarPart::Input) return "the input" + module;
    const bool derivation = where.part == GrammarPart::Rule;
    const PointRule& rule = derivation ? grammar.rules[where.rule] : grammar.interpretations[where.pass][where.rule];
    std::string text = "rule " + std::to_string(where.rule + 1);
    if (!derivation) text = "interpretation " + std::to_string(where.pass + 1) + ", " + text;
    if (!rule.label.empty()) text += " (`" + rule.label + "`)";
    return text + module;
}

std::string finding_text(const AffineFinding& finding) {
    switch (finding.verdict) {
    case AffineVerdict::SumIsNotOne:
        return "the coefficients sum to " + finding.sum + ", not to 1";
    case AffineVerdict::AffineForTheseConstants:
        return "the coefficients sum to " + finding.sum +
               ", which is 1 for these values of the constants and not for all";
    case AffineVerdict::MixesCoordinates:
        return "literal points or coordinates take part: it does not move with the other points";
    case AffineVerdict::NotDecided:
        return (finding.sum.empty() ? "" : "the coefficients sum to " + finding.sum + ": ") + "not decided, " +
               finding.reason;
    case AffineVerdict::Affine:
        break;
    }
    return "";
}

std::string staying_text(const StayingContext& context, const PointGrammar& grammar) {
    const auto letters = [&](const Word& word) { return printable(to_string(word, grammar.letters)); };
    std::string text = "`" + letters({context.letter}) + "`";
    if (!context.left.empty()) text += " after `" + letters(context.left) + "`";
    if (!context.right.empty())
        text += std::string(context.left.empty() ? "" : " and") + " before `" + letters(context.right) + "`";
    text += context.outermost ? ", the end of its axis" : ", inside the word";
    if (context.table) text += ", table " + printable(grammar.tables[*context.table]);
    if (context.largest == 0) return text + ", from the axiom";
    text += ", from " + std::to_string(context.smallest);
    if (context.largest > context.smallest) text += " to " + std::to_string(context.largest);
    return text + (context.largest == 1 ? " point" : " points");
}

std::string point_validation_text(const PointValidation& validation, const PointGrammar& grammar,
                                  const GrammarSourceText& source) {
    std::string text = grammar.name.empty() ? "The grammar is " : printable(grammar.name) + ": ";
    text += validation.valid ? "valid\n" : "not valid\n";
    text += problems_text(validation, source);
    text += unsound_text(validation, grammar, source);
    if (!validation.coverage) return text;
    text +=
        "\n" + labelled("rules", std::to_string(grammar.rules.size()) + (grammar.ring ? ", of a ring" : "") +
                                     (validation.dimension > 2
                                          ? ", for points of " + std::to_string(validation.dimension) + " coordinates"
                                          : ""));
    text += labelled("positions", affine_text(validation));
    text += coverage_text(*validation.coverage, grammar);
    if (validation.compilation) text += compilation_text(*validation.compilation, source);
    if (validation.mask)
        text += "\n" + mask_facts_text(*validation.mask);
    else if (validation.compilation && validation.compilation->compiles)
        text += labelled("mask", "none: far from all ends the rules do not treat all points alike");
    if (validation.compilation && validation.compilation->twin)
        text += labelled("intervals", twin_text(*validation.compilation->twin));
    return text;
}

} // namespace internode
