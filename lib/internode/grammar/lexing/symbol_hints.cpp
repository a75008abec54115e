// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/symbol_hints.h"

#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

/// Edit distance is slow: it is computed for the errors that are shown and in alphabets up to this size only, and
/// not for names so short that every other name is near.
constexpr std::size_t searched_symbols = 1000;
constexpr std::size_t searched_name = 3;

} // namespace

std::string SymbolHints::near_name(std::string_view name) {
    assert(!name.empty());
    std::string other(name);
    other.front() = static_cast<char>(other.front() ^ 0x20); // the cases of an ASCII letter differ in this bit only
    if (alphabet_.find(other)) return other;
    const bool searched = name.size() >= searched_name && alphabet_.size() <= searched_symbols;
    if (!searched || searches_ == shown_errors) return {};
    ++searches_;
    return did_you_mean(name, alphabet_.names());
}

std::string SymbolHints::zeros_apart(std::string_view name) const {
    const std::size_t letters = name.find_last_not_of('0') + 1;
    if (letters == name.size() || !alphabet_.find(name.substr(0, letters))) return {};
    std::string apart(name.substr(0, letters));
    for (std::size_t i = letters; i < name.size(); ++i) apart += " 0";
    return fmt::format("`{}` is one symbol: write `{}`", name, apart);
}

std::string SymbolHints::in_word(std::string_view name) {
    if (std::string apart = zeros_apart(name); !apart.empty()) return apart;
    const std::string near = near_name(name);
    return near.empty() ? std::string() : fmt::format("did you mean `{}`?", near);
}

std::string SymbolHints::in_grammar(std::string_view name) {
    std::string hint = in_word(name);
    if (hint.starts_with('`')) return hint;
    if (hint.empty()) return fmt::format("write `{0} -> {0}` if it should stay whole", name);
    return fmt::format("{0} Or write `{1} -> {1}` if it should stay whole", hint, name);
}

} // namespace internode
