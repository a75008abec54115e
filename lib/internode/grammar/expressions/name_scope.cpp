// SPDX-License-Identifier: MIT

#include "internode/grammar/expressions/name_scope.h"

#include "internode/text/ascii.h"

#include <algorithm>
#include <cassert>

namespace internode {

void DefinitionTable::announce(std::string_view name, std::size_t offset) {
    announced_.try_emplace(std::string(name), offset);
}

std::optional<std::size_t> DefinitionTable::announced(std::string_view name) const {
    const auto found = announced_.find(std::string(name));
    return found == announced_.end() ? std::nullopt : std::optional(found->second);
}

void DefinitionTable::add(Definition definition) {
    assert(!definition.name.empty() && !index_.contains(definition.name));
    index_.emplace(definition.name, static_cast<std::uint32_t>(definitions_.size()));
    definitions_.push_back(std::move(definition));
}

NameMeaning DefinitionTable::find(std::string_view name) const {
    const auto found = index_.find(std::string(name));
    if (found == index_.end()) return {};
    const bool is_constant = definitions_[found->second].formals.empty();
    return {is_constant ? NameMeaning::Kind::Constant : NameMeaning::Kind::Function, found->second};
}

std::vector<std::string> DefinitionTable::names() const {
    std::vector<std::string> names;
    for (const Definition& definition : definitions_) names.push_back(definition.name);
    return names;
}

bool NameScope::add_formal(std::string_view name) {
    const bool is_new = index_.emplace(std::string(name), static_cast<std::uint32_t>(formals_.size())).second;
    if (is_new) formals_.emplace_back(name);
    return is_new;
}

NameMeaning NameScope::find(std::string_view name) {
    if (const auto found = index_.find(std::string(name)); found != index_.end())
        return {NameMeaning::Kind::Formal, found->second};
    if (const NameMeaning meaning = table_->find(name); meaning.kind != NameMeaning::Kind::Unknown) return meaning;
    const bool adopts =
        unknown_ == UnknownNames::AreFormals || (unknown_ == UnknownNames::FirstIsFormal && formals_.empty());
    if (!adopts) return {};
    add_formal(name);
    return {NameMeaning::Kind::Formal, static_cast<std::uint32_t>(formals_.size() - 1)};
}

bool is_name(std::string_view run) {
    return !run.empty() && is_ascii_letter(run.front());
}

const std::vector<std::string>& expression_words() {
    static const std::vector<std::string> words{"and", "or", "not", "min", "max", "floor", "abs", "sqrt"};
    return words;
}

bool is_expression_word(std::string_view name) {
    return std::ranges::find(expression_words(), name) != expression_words().end();
}

} // namespace internode
