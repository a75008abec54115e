// SPDX-License-Identifier: MIT

#include "internode/point/constants.h"

#include "internode/point/kinds.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

/// A call in progress: calls nest as deep as the text has definitions, so they have a stack of their own.
struct Frame {
    const Expression* expression = nullptr;
    std::size_t next = 0;      ///< instruction
    std::size_t arguments = 0; ///< where they begin on the stack of values
};

class KnownEvaluation {
public:
    KnownEvaluation(const PointGrammar& grammar, std::span<const KnownNumber> constants)
        : grammar_(grammar)
        , constants_(constants) {}

    KnownNumber run(const Expression& expression, std::vector<KnownNumber> arguments) {
        values_ = std::move(arguments);
        frames_.push_back({&expression, 0, 0});
        while (!frames_.empty()) {
            Frame& frame = frames_.back();
            if (frame.next == frame.expression->code.size())
                leave();
            else
                step(*frame.expression, frame.expression->code[frame.next++], frame.arguments);
        }
        assert(values_.size() == 1);
        return std::move(values_.back());
    }

private:
    /// The arguments of the call give way to its value.
    void leave() {
        const std::size_t arguments = frames_.back().arguments;
        frames_.pop_back();
        KnownNumber value = std::move(values_.back());
        values_.resize(arguments);
        values_.push_back(std::move(value));
    }

    void step(const Expression& expression, Instruction instruction, std::size_t arguments) {
        const std::uint32_t operand = instruction.operand;
        switch (instruction.operation) {
        case Operation::Number:
            values_.push_back({expression.numbers[operand], 0});
            break;
        case Operation::Formal:
            values_.push_back(KnownNumber(values_[arguments + operand]));
            break;
        case Operation::Constant:
            values_.push_back(constants_[operand]);
            break;
        case Operation::Call: {
            const Definition& called = grammar_.definitions[operand];
            frames_.push_back({&called.value, 0, values_.size() - called.formals.size()});
            break;
        }
        default:
            compute(instruction);
        }
    }

    void compute(Instruction instruction) {
        const std::size_t first = values_.size() - operand_count(instruction, 0);
        KnownNumber value = apply_operation(instruction.operation, std::span(values_).subspan(first));
        values_.resize(first);
        values_.push_back(std::move(value));
    }

    const PointGrammar& grammar_;
    std::span<const KnownNumber> constants_;
    std::vector<KnownNumber> values_;
    std::vector<Frame> frames_;
};

std::vector<std::string> constant_names(const PointGrammar& grammar) {
    std::vector<std::string> names;
    for (const Definition& definition : grammar.definitions)
        if (definition.formals.empty()) names.push_back(definition.name);
    return names;
}

PointProblem unknown_constant(const std::string& name, const PointGrammar& grammar) {
    const std::vector<std::string> names = constant_names(grammar);
    const std::string near = did_you_mean(name, names);
    std::string hint;
    if (names.empty())
        hint = "it has none";
    else if (near.empty())
        hint = fmt::format("its constants: {}",
                           fmt::join(std::span(names).first(std::min<std::size_t>(10, names.size())), ", "));
    else
        hint = fmt::format("did you mean `{}`?", near);
    return {{}, fmt::format("the grammar has no constant `{}`", name), std::move(hint)};
}

void check_settings(const PointGrammar& grammar, const std::map<std::string, Rational>& settings,
                    std::vector<PointProblem>& problems) {
    for (const auto& [name, value] : settings) {
        const auto found = std::ranges::find(grammar.definitions, name, &Definition::name);
        if (found == grammar.definitions.end())
            problems.push_back(unknown_constant(name, grammar));
        else if (!found->formals.empty())
            problems.push_back({found->place, fmt::format("`{}` is a function: only constants can be set", name), ""});
    }
}

/// All formals of a function are numbers.
bool is_a_number(const Definition& definition, const PointGrammar& grammar, std::vector<PointProblem>& problems) {
    const std::vector<Extent> numbers(definition.formals.size(), 0);
    return expect_type({}, fmt::format("`{}`", definition.name), definition.value, {definition.formals, numbers},
                       grammar, problems);
}

/// Values of the constants one after the other, with what is left to spend.
class ConstantMaker {
public:
    ConstantMaker(const PointGrammar& grammar, std::vector<PointProblem>& problems)
        : grammar_(grammar)
        , problems_(problems)
        , costs_(definition_costs(grammar)) {}

    KnownNumber value_of(std::size_t index, std::span<const KnownNumber> earlier, const Rational* setting) {
        const Definition& definition = grammar_.definitions[index];
        if (!is_a_number(definition, grammar_, problems_)) {
            broken_ = true;
            return {};
        }
        if (costs_[index] > max_expression_operations) {
            problems_.push_back(too_costly(definition, max_expression_operations));
            broken_ = true;
        }
        // A function that uses a definition in error would be in error too, and is not evaluated.
        if (broken_ || !definition.formals.empty()) return {Rational(0), 0};
        return checked(definition, setting ? KnownNumber{*setting, 0} : spend(index, earlier));
    }

private:
    static PointProblem too_costly(const Definition& definition, std::uint64_t limit) {
        return {definition.place,
                fmt::format("`{}` takes more than {} operations when the functions that are called are written out",
                            definition.name, limit),
                "a function that calls another twice doubles its work"};
    }

    KnownNumber spend(std::size_t index, std::span<const KnownNumber> earlier) {
        if (costs_[index] > max_constant_operations - spent_) {
            problems_.push_back(too_costly(grammar_.definitions[index], max_constant_operations));
            return {Rational(0), 0};
        }
        spent_ += costs_[index];
        return evaluate_known(grammar_.definitions[index].value, {}, grammar_, earlier);
    }

    KnownNumber checked(const Definition& definition, KnownNumber value) {
        if (std::isfinite(nearest(value))) return value;
        problems_.push_back({definition.place, fmt::format("`{}` is not a finite number", definition.name), ""});
        return {Rational(0), 0};
    }

    const PointGrammar& grammar_;
    std::vector<PointProblem>& problems_;
    std::vector<std::uint64_t> costs_;
    std::uint64_t spent_ = 0;
    bool broken_ = false;
};

} // namespace

std::uint64_t operations(const Expression& expression, std::span<const std::uint64_t> definition_costs) {
    std::uint64_t sum = 0;
    for (const Instruction& instruction : expression.code) {
        sum += instruction.operation == Operation::Call ? 1 + definition_costs[instruction.operand] : 1;
        if (sum > max_expression_operations) return max_expression_operations + 1;
    }
    return sum;
}

std::vector<std::uint64_t> definition_costs(const PointGrammar& grammar) {
    std::vector<std::uint64_t> costs;
    for (const Definition& definition : grammar.definitions) costs.push_back(operations(definition.value, costs));
    return costs;
}

KnownNumber evaluate_known(const Expression& expression, std::vector<KnownNumber> arguments,
                           const PointGrammar& grammar, std::span<const KnownNumber> constants) {
    return KnownEvaluation(grammar, constants).run(expression, std::move(arguments));
}

std::vector<KnownNumber> constant_values(const PointGrammar& grammar, const std::map<std::string, Rational>& settings,
                                         std::vector<PointProblem>& problems) {
    check_settings(grammar, settings, problems);
    ConstantMaker maker(grammar, problems);
    std::vector<KnownNumber> values;
    for (std::size_t i = 0; i < grammar.definitions.size(); ++i) {
        const auto setting = settings.find(grammar.definitions[i].name);
        values.push_back(maker.value_of(i, values, setting == settings.end() ? nullptr : &setting->second));
    }
    return values;
}

} // namespace internode
