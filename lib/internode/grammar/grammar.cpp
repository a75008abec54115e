// SPDX-License-Identifier: MIT

#include "internode/grammar/grammar.h"

namespace internode {

namespace {

GrammarKind kind(const IntervalGrammar&) {
    return GrammarKind::Intervals;
}
GrammarKind kind(const PointGrammar&) {
    return GrammarKind::Points;
}

} // namespace

GrammarKind kind_of(const Grammar& grammar) {
    return std::visit([](const auto& one) { return kind(one); }, grammar);
}

const std::string& name_of(const Grammar& grammar) {
    return std::visit([](const auto& one) -> const std::string& { return one.name; }, grammar);
}

} // namespace internode
