// SPDX-License-Identifier: MIT

#include "internode/grammar/points/template_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/points/module_reader.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

/// False after a complaint: the modules would be too many, or their expressions too long.
bool may_repeat(const RawModule& raw, std::size_t instructions, PointContext& context) {
    assert(raw.power >= 1 && raw.place.bytes > 0);
    std::size_t& modules = context.budget.modules;
    assert(modules <= max_point_modules);
    if (raw.power > max_point_modules - modules) {
        context.complaints.add("module.too-many", raw.place,
                               fmt::format("more than {} modules in one grammar", max_point_modules));
        return false;
    }
    modules += raw.power;
    if (raw.power == 1) return true;
    context.repeated = true;
    context.repeated_instructions += (raw.power - 1) * instructions;
    if (context.repeated_instructions > max_repeated_instructions)
        context.complaints.add(
            "module.too-many-repeated-operations", raw.place,
            fmt::format("powers repeat more than {} operations in one grammar", max_repeated_instructions));
    else if (raw.power > max_line_bytes / raw.place.bytes)
        context.complaints.add("module.power-too-large", raw.place,
                               fmt::format("this power makes a line of more than {} bytes", max_line_bytes));
    else
        return true;
    return false;
}

ModuleTemplate read_template(const RawModule& raw, NameScope& scope, PointContext& context) {
    ModuleTemplate result;
    result.letter = context.letters.use(raw.letter, raw.parameters.size(), LetterTable::Use::Made, raw.place);
    result.place = SourcePlace{raw.place.offset, raw.place.bytes};
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
