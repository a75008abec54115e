// SPDX-License-Identifier: MIT

#include "internode/grammar/template_reader.h"

#include "internode/grammar/limits.h"
#include "internode/grammar/module_reader.h"

#include <fmt/format.h>

namespace internode {

namespace {

/// False after a complaint: the modules would be too many, or their expressions too long.
bool may_repeat(const RawModule& raw, std::size_t instructions, PointContext& context) {
    PointBudget& budget = context.budget;
    if (raw.power > max_point_modules - budget.modules) {
        context.complaints.add(raw.place, fmt::format("more than {} modules in one grammar", max_point_modules));
        return false;
    }
    const std::size_t more = (raw.power - 1) * instructions;
    if (more > max_point_instructions - budget.instructions) {
        context.complaints.add(
            raw.place, fmt::format("this power makes more than {} operations in one grammar", max_point_instructions));
        return false;
    }
    budget.modules += raw.power;
    budget.instructions += more;
    context.repeated = context.repeated || raw.power > 1;
    return true;
}

ModuleTemplate read_template(const RawModule& raw, NameScope& scope, PointContext& context) {
    ModuleTemplate result;
    result.letter = context.letters.use(raw.letter, raw.parameters.size(), LetterTable::Use::Made, raw.place);
    result.place = {raw.place.offset, raw.place.bytes};
    ExpressionContext expressions = context.expressions(scope);
    for (const std::span<const Token> parameter : raw.parameters)
        if (auto value = read_expression(parameter, Wanted::Value, expressions))
            result.arguments.push_back(*std::move(value));
    return result;
}

} // namespace

std::vector<ModuleTemplate> read_templates(std::span<const Token> tokens, NameScope& scope, PointContext& context) {
    std::vector<ModuleTemplate> result;
    const RawModules read = read_modules(tokens, ModulePlace::Template, context.text, context.complaints);
    for (const RawModule& raw : read.modules) {
        const std::size_t before = context.budget.instructions;
        const ModuleTemplate module = read_template(raw, scope, context);
        if (!may_repeat(raw, context.budget.instructions - before, context)) break;
        result.insert(result.end(), raw.power, module);
    }
    return result;
}

} // namespace internode
