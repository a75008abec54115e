// SPDX-License-Identifier: MIT

#include "internode/point/effective_input.h"

#include <cassert>

namespace internode {

std::optional<PointInput> default_input(const PointGrammar& grammar) {
    const std::optional<Symbol> point = find_letter(grammar, "P", 1);
    if (!point) return std::nullopt;
    PointInput input;
    input.formal = "v";
    input.each.push_back({*point, {Expression{{{Operation::Formal, 0}}, {}, {}}}, {}});
    return input;
}

std::optional<PointInput> effective_input(const PointGrammar& grammar, PointStart start) {
    if (start == PointStart::Axiom) return std::nullopt;
    if (grammar.input) return grammar.input;
    return start == PointStart::Input || !grammar.axiom ? default_input(grammar) : std::nullopt;
}

const std::vector<ModuleTemplate>& input_part(const PointInput& input, std::size_t i, std::size_t count) {
    assert(i < count);
    if (!input.has_ends || (i > 0 && i + 1 < count)) return input.each;
    return i == 0 ? input.first : input.last;
}

} // namespace internode
