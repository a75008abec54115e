// SPDX-License-Identifier: MIT
//
// What contexts see, by its definition: walking letter by letter, counting brackets.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace internode::reference {

/// The bracket that belongs to the one at i, or none.
inline std::optional<std::size_t> partner(std::string_view word, std::size_t i) {
    const bool opens = word[i] == '[';
    if (!opens && word[i] != ']') return std::nullopt;
    int depth = 0;
    for (std::size_t j = i; j < word.size(); j = opens ? j + 1 : j - 1) {
        if (word[j] == '[') depth += opens ? 1 : -1;
        if (word[j] == ']') depth += opens ? -1 : 1;
        if (depth == 0) return j;
    }
    return std::nullopt;
}

inline std::optional<std::size_t> module_before(std::string_view word, bool ring, std::size_t i) {
    for (std::size_t steps = 0; steps < 3 * word.size() + 3; ++steps) {
        if (i == 0 && !ring) return std::nullopt;
        i = (i + word.size() - 1) % word.size();
        const std::optional<std::size_t> other = partner(word, i);
        if (!other) return i;
        if (word[i] == ']') i = *other;
    }
    return std::nullopt;
}

inline std::optional<std::size_t> module_after(std::string_view word, bool ring, std::size_t i) {
    for (std::size_t steps = 0; steps < 3 * word.size() + 3; ++steps) {
        if (i + 1 == word.size() && !ring) return std::nullopt;
        i = (i + 1) % word.size();
        const std::optional<std::size_t> other = partner(word, i);
        if (!other) return i;
        if (word[i] == ']') return std::nullopt;
        i = *other;
    }
    return std::nullopt;
}

/// Whether left < predecessor > right fits with its strict predecessor at i.
inline bool fits(std::string_view word, bool ring, std::size_t i, const std::string& left,
                 const std::string& predecessor, const std::string& right) {
    if (word.substr(i, predecessor.size()) != predecessor) return false;
    std::optional<std::size_t> at = i;
    for (std::size_t k = left.size(); k-- > 0;) {
        at = module_before(word, ring, *at);
        if (!at || word[*at] != left[k]) return false;
    }
    at = i + predecessor.size() - 1;
    for (const char letter : right) {
        at = module_after(word, ring, *at);
        if (!at || word[*at] != letter) return false;
    }
    return true;
}

} // namespace internode::reference
