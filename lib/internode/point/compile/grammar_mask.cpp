// SPDX-License-Identifier: MIT

#include "internode/point/compile/grammar_mask.h"

#include "internode/point/compile/compile.h"
#include "internode/stencil/cell_mask.h"

namespace internode {

std::optional<UniformMask> uniform_mask(const CompiledGrammar& compiled) {
    if (!compiled.interior()) return std::nullopt;
    const std::uint32_t start[] = {*compiled.interior()};
    if (normal_form(compiled.rules(), start).rules.size() != 1) return std::nullopt;
    return uniform_mask(compiled.rules()[start[0]]);
}

std::optional<UniformMask> uniform_mask(const PointSystem& system) {
    const Compilation compilation = compile(system, {many_points});
    return compilation.compiled ? uniform_mask(*compilation.compiled) : std::nullopt;
}

} // namespace internode
