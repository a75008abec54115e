// SPDX-License-Identifier: MIT

#include "internode/word/symbol.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

Symbol Alphabet::add(std::string_view name) {
    assert(!name.empty());
    if (const auto known = find(name)) return *known;
    const Symbol symbol = to_symbol(names_.size());
    names_.emplace_back(name);
    symbols_.emplace(names_.back(), symbol);
    assert(symbols_.size() == names_.size());
    return symbol;
}

std::optional<Symbol> Alphabet::find(std::string_view name) const {
    const auto place = symbols_.find(std::string(name));
    if (place == symbols_.end()) return std::nullopt;
    return place->second;
}

const std::string& Alphabet::name(Symbol symbol) const {
    static const std::string zero = "0";
    if (symbol == zero_interval) return zero;
    if (to_index(symbol) >= names_.size()) throw std::out_of_range("a symbol of another alphabet");
    return names_[to_index(symbol)];
}

std::string to_string(WordView word, const Alphabet& alphabet) {
    const bool single = std::ranges::all_of(alphabet.names(), [](const std::string& name) { return name.size() == 1; });
    std::string text;
    bool after_zero = false;
    for (const Symbol symbol : word) {
        const bool is_zero = symbol == zero_interval;
        if (!text.empty() && (!single || is_zero || after_zero)) text += ' ';
        text += alphabet.name(symbol);
        after_zero = is_zero;
    }
    return text;
}

std::size_t WordHash::operator()(const Word& word) const noexcept {
    std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a, a symbol at a time
    for (const Symbol symbol : word) {
        hash ^= to_index(symbol);
        hash *= 0x100000001b3;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

} // namespace internode
