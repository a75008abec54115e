// SPDX-License-Identifier: MIT

#include "internode/expression/constants.h"

#include "internode/expression/known_value.h"
#include "internode/expression/limits.h"
#include "internode/expression/type.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

std::vector<std::string> constant_names(std::span<const Definition> definitions) {
    std::vector<std::string> names;
    for (const Definition& definition : definitions)
        if (definition.formals.empty()) names.push_back(definition.name);
    return names;
}

ExpressionProblem unknown_constant(const std::string& name, std::span<const Definition> definitions) {
    const std::vector<std::string> names = constant_names(definitions);
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

void check_settings(std::span<const Definition> definitions, const std::map<std::string, Rational>& settings,
                    std::vector<ExpressionProblem>& problems) {
    for (const auto& [name, value] : settings) {
        const auto found = std::ranges::find(definitions, name, &Definition::name);
        if (found == definitions.end())
            problems.push_back(unknown_constant(name, definitions));
        else if (!found->formals.empty())
            problems.push_back({found->place, fmt::format("`{}` is a function: only constants can be set", name), ""});
    }
}

/// All formals of a function are numbers.
bool is_a_number(const Definition& definition, std::span<const Definition> definitions,
                 std::vector<ExpressionProblem>& problems) {
    const std::vector<Extent> numbers(definition.formals.size(), 0);
    return expect_type({}, fmt::format("`{}`", definition.name), definition.value, {definition.formals, numbers},
                       definitions, problems);
}

/// Values of the constants one after the other, with what is left to spend.
class ConstantMaker {
public:
    ConstantMaker(std::span<const Definition> definitions, std::vector<ExpressionProblem>& problems)
        : definitions_(definitions)
        , problems_(problems)
        , costs_(definition_costs(definitions)) {}

    KnownNumber value_of(std::size_t index, std::span<const KnownNumber> earlier, const Rational* setting) {
        const Definition& definition = definitions_[index];
        if (!is_a_number(definition, definitions_, problems_)) {
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
    static ExpressionProblem too_costly(const Definition& definition, std::uint64_t limit) {
        return {definition.place,
                fmt::format("`{}` takes more than {} operations when the functions that are called are written out",
                            definition.name, limit),
                "a function that calls another twice doubles its work"};
    }

    KnownNumber spend(std::size_t index, std::span<const KnownNumber> earlier) {
        if (costs_[index] > max_constant_operations - spent_) {
            problems_.push_back(too_costly(definitions_[index], max_constant_operations));
            return {Rational(0), 0};
        }
        spent_ += costs_[index];
        return evaluate_known(definitions_[index].value, {}, {definitions_, earlier});
    }

    KnownNumber checked(const Definition& definition, KnownNumber value) {
        if (std::isfinite(nearest(value))) return value;
        problems_.push_back({definition.place, fmt::format("`{}` is not a finite number", definition.name), ""});
        return {Rational(0), 0};
    }

    std::span<const Definition> definitions_;
    std::vector<ExpressionProblem>& problems_;
    std::vector<std::uint64_t> costs_;
    std::uint64_t spent_ = 0;
    bool broken_ = false;
};

} // namespace

std::vector<KnownNumber> constant_values(std::span<const Definition> definitions,
                                         const std::map<std::string, Rational>& settings,
                                         std::vector<ExpressionProblem>& problems) {
    check_settings(definitions, settings, problems);
    ConstantMaker maker(definitions, problems);
    std::vector<KnownNumber> values;
    for (std::size_t i = 0; i < definitions.size(); ++i) {
        const auto setting = settings.find(definitions[i].name);
        values.push_back(maker.value_of(i, values, setting == settings.end() ? nullptr : &setting->second));
    }
    return values;
}

} // namespace internode
