// SPDX-License-Identifier: MIT
//
// An argument is read with the constants as symbols first; where its sum is not 1 as an identity, once more with their
// values. Where min, max and the like stand for variables, only an example refutes, and it must miss 1 clearly.

#include "internode/point/check/affine.h"

#include "internode/expression/symbolic_value.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace internode {

namespace {

constexpr std::uint32_t samples = 6;
// An example must miss 1 by more than doubles can err in a few dozen operations on numbers near 1.
constexpr double clear_difference = 1e-6;

/// Σ of the coefficients; none beyond the limits.
std::optional<Symbolic> sum_of(const SymbolicValue& point) {
    std::optional<Symbolic> sum = Symbolic();
    for (const auto& [formal, coefficient] : point.coefficients) {
        sum = add(*sum, coefficient);
        if (!sum) return std::nullopt;
    }
    return sum;
}

class AffineCheck {
public:
    AffineCheck(const PointGrammar& grammar, std::span<const KnownNumber> constants)
        : grammar_(grammar)
        , reader_({grammar.definitions, constants}) {}

    void modules(const std::vector<ModuleTemplate>& word, ArgumentPlace where, std::span<const Extent> extents,
                 std::span<const std::string> formals) {
        for (std::uint32_t module = 0; module < word.size(); ++module)
            for (std::uint32_t argument = 0; argument < word[module].arguments.size(); ++argument) {
                where.module = module;
                where.argument = argument;
                expression(word[module].arguments[argument], where, extents, formals);
            }
    }

    void axiom_and_input() {
        if (grammar_.axiom) modules(*grammar_.axiom, {.part = GrammarPart::Axiom}, {}, {});
        if (!grammar_.input) return;
        const Extent point[] = {1};
        const std::string formal[] = {grammar_.input->formal};
        modules(grammar_.input->first, {.part = GrammarPart::Input, .input = InputPart::First}, point, formal);
        modules(grammar_.input->each, {.part = GrammarPart::Input, .input = InputPart::Each}, point, formal);
        modules(grammar_.input->last, {.part = GrammarPart::Input, .input = InputPart::Last}, point, formal);
    }

    void rule(const PointRule& rule, const ArgumentPlace& where, const Layout& layout) {
        std::vector<Extent> extents;
        for (const auto* letters : {&rule.left, &rule.predecessor, &rule.right})
            for (const Symbol letter : *letters) {
                const auto& parameters = layout[to_index(letter)];
                if (!parameters) return;
                extents.insert(extents.end(), parameters->begin(), parameters->end());
            }
        modules(rule.successor, where, extents, rule.formals);
    }

    [[nodiscard]] std::vector<AffineFinding> take() { return std::move(findings_); }

private:
    void expression(const Expression& expression, const ArgumentPlace& where, std::span<const Extent> extents,
                    std::span<const std::string> formals) {
        const auto value = reader_.read(expression, extents, formals);
        if (value && !value->is_point) return;
        AffineFinding finding{.where = where, .place = expression.place, .sum = "", .reason = ""};
        if (!value) {
            if (!may_be_point(expression, extents)) return;
            finding.verdict = AffineVerdict::NotDecided;
            finding.reason = reader_.undecided();
        } else if (value->has_coordinates) {
            finding.verdict = AffineVerdict::MixesCoordinates;
        } else {
            decide(*value, finding);
            if (finding.verdict != AffineVerdict::Affine && holds_for_values(expression, extents, formals))
                finding.verdict = AffineVerdict::AffineForTheseConstants;
        }
        findings_.push_back(std::move(finding));
    }

    void decide(const SymbolicValue& point, AffineFinding& finding) {
        const auto sum = sum_of(point);
        if (!sum) {
            finding.verdict = AffineVerdict::NotDecided;
            finding.reason = "the sum of its coefficients is larger than the check goes";
            return;
        }
        finding.sum = to_string(*sum, reader_.names());
        finding.verdict = compare_with_one(*sum);
        if (finding.verdict == AffineVerdict::NotDecided)
            finding.reason = "identities among min, max, floor, abs and sqrt are not known to the check";
    }

    [[nodiscard]] AffineVerdict compare_with_one(const Symbolic& sum) const {
        if (sum.is_one()) return AffineVerdict::Affine;
        const auto variables = sum.variables();
        const bool exact =
            std::ranges::none_of(variables, [&](SymbolicVariable variable) { return reader_.is_opaque(variable); });
        if (exact) return AffineVerdict::SumIsNotOne;
        for (std::uint32_t sample = 0; sample < samples; ++sample) {
            const double value = sum.evaluate(reader_.sample(sample));
            if (std::isfinite(value) && std::fabs(value - 1) > clear_difference) return AffineVerdict::SumIsNotOne;
        }
        return AffineVerdict::NotDecided;
    }

    [[nodiscard]] bool holds_for_values(const Expression& expression, std::span<const Extent> extents,
                                        std::span<const std::string> formals) {
        const auto value = reader_.read(expression, extents, formals, ConstantReading::Values);
        const auto sum = value ? sum_of(*value) : std::nullopt;
        return sum && sum->is_one();
    }

    /// Where the value is not known: an expression without a point formal or a literal point is a number.
    [[nodiscard]] static bool may_be_point(const Expression& expression, std::span<const Extent> extents) {
        bool point = false;
        for (const Instruction instruction : expression.code) {
            if (instruction.operation == Operation::Coordinate) return false;
            point = point || instruction.operation == Operation::Point ||
                    (instruction.operation == Operation::Formal && extents[instruction.operand] > 0);
        }
        return point;
    }

    const PointGrammar& grammar_;
    SymbolicReader reader_;
    std::vector<AffineFinding> findings_;
};

const PointRule& rule_at(const PointGrammar& grammar, const ArgumentPlace& where) {
    return where.part == GrammarPart::Rule ? grammar.rules.at(where.rule)
                                           : grammar.interpretations.at(where.pass).at(where.rule);
}

const std::vector<ModuleTemplate>& word_at(const PointGrammar& grammar, const ArgumentPlace& where) {
    if (where.part == GrammarPart::Axiom) return grammar.axiom.value();
    if (where.part != GrammarPart::Input) return rule_at(grammar, where).successor;
    const PointInput& input = grammar.input.value();
    if (where.input == InputPart::Each) return input.each;
    return where.input == InputPart::First ? input.first : input.last;
}

} // namespace

std::vector<AffineFinding> affine_findings(const PointGrammar& grammar, std::span<const KnownNumber> constants,
                                           std::span<const Layout> layouts) {
    assert(!layouts.empty() && layouts.size() >= grammar.interpretations.size());
    AffineCheck check(grammar, constants);
    check.axiom_and_input();
    for (std::uint32_t rule = 0; rule < grammar.rules.size(); ++rule)
        check.rule(grammar.rules[rule], {.part = GrammarPart::Rule, .rule = rule}, layouts[0]);
    for (std::uint32_t pass = 0; pass < grammar.interpretations.size(); ++pass)
        for (std::uint32_t rule = 0; rule < grammar.interpretations[pass].size(); ++rule)
            check.rule(grammar.interpretations[pass][rule],
                       {.part = GrammarPart::Interpretation, .pass = pass, .rule = rule}, layouts[pass]);
    return check.take();
}

std::vector<AffineFinding> affine_findings(const PointSystem& system) {
    const PointGrammar& grammar = system.grammar();
    std::vector<Layout> layouts;
    for (std::size_t pass = 0; pass <= grammar.interpretations.size(); ++pass) layouts.push_back(system.layout(pass));
    return affine_findings(grammar, system.scope().constants, layouts);
}

std::vector<AffineFinding> wrong_sums(const PointSystem& system) {
    std::vector<AffineFinding> wrong = affine_findings(system);
    std::erase_if(wrong, [&](const AffineFinding& finding) {
        const bool unused = (finding.where.part == GrammarPart::Axiom && system.start() == PointStart::Input) ||
                            (finding.where.part == GrammarPart::Input && system.start() == PointStart::Axiom);
        return unused || finding.verdict != AffineVerdict::SumIsNotOne;
    });
    return wrong;
}

const Expression& expression_at(const PointGrammar& grammar, const ArgumentPlace& where) {
    return word_at(grammar, where).at(where.module).arguments.at(where.argument);
}

std::vector<std::string> formals_at(const PointGrammar& grammar, const ArgumentPlace& where) {
    if (where.part == GrammarPart::Axiom) return {};
    if (where.part == GrammarPart::Input) return {grammar.input.value().formal};
    return rule_at(grammar, where).formals;
}

bool is_sound(AffineVerdict verdict) {
    return verdict == AffineVerdict::Affine || verdict == AffineVerdict::MixesCoordinates;
}

} // namespace internode
