// SPDX-License-Identifier: MIT

#include "internode/point/infer/reduction.h"

#include "internode/point/start_word.h"
#include "internode/point/strands.h"

#include <algorithm>
#include <utility>

namespace internode {

bool reduces(const PointGrammar& grammar) {
    return std::ranges::any_of(grammar.rules, [](const PointRule& rule) { return rule.predecessor.size() > 1; });
}

std::size_t reduced_arity(const PointGrammar& grammar) {
    if (grammar.rules.empty()) return 1;
    const std::size_t arity = grammar.rules.front().predecessor.size();
    const bool is_plain = std::ranges::all_of(grammar.rules, [arity](const PointRule& rule) {
        return rule.predecessor.size() == arity && rule.successor.size() == 1;
    });
    return is_plain ? arity : 1;
}

Reduction reduced(const PointSystem& system, std::span<const double> points, std::uint64_t levels,
                  std::uint64_t phase) {
    Reduction result;
    ModuleWord word = input_word(system, points);
    for (std::uint64_t level = 0; level < levels; ++level) {
        DeriveOptions options;
        options.phase = word.empty() ? 0 : phase % word.size();
        Derivation derived = derive(system, word, 1, options);
        result.problem = std::move(derived.problem);
        if (result.problem) return result;
        word = std::move(derived.word);
        result.polygons.push_back(strands(word, system, 0).points);
        if (result.polygons.back().empty()) return result;
    }
    return result;
}

} // namespace internode
