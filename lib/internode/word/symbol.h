// SPDX-License-Identifier: MIT
//
// Symbols, alphabets and words.
//
// A symbol A_i labels a knot interval (Nivoliers et al. 2012, section 2.1.1). It is an index in an alphabet of n
// names; the reserved letter `0`, the interval of length zero, belongs to every word and to no alphabet.

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace internode {

/// Index of a symbol in its alphabet, 0 … n-1, or zero_interval.
enum class Symbol : std::uint32_t {};

/// The reserved letter `0`: an interval of length zero, which rewriting keeps (0 -> 0).
inline constexpr Symbol zero_interval{std::numeric_limits<std::uint32_t>::max()};

[[nodiscard]] constexpr std::size_t to_index(Symbol symbol) {
    return static_cast<std::size_t>(symbol);
}
[[nodiscard]] constexpr Symbol to_symbol(std::size_t index) {
    return static_cast<Symbol>(index);
}

using Word = std::vector<Symbol>;
using WordView = std::span<const Symbol>;

/// Whether a word has two ends or its last letter is followed by its first.
enum class Ends { Open, Circular };

/// The names of n symbols, in the order of their first appearance.
class Alphabet {
public:
    /// The symbol of that name, added when it is new.
    Symbol add(std::string_view name);
    [[nodiscard]] std::optional<Symbol> find(std::string_view name) const;
    /// The name of a symbol of this alphabet; "0" for zero_interval. \throw std::out_of_range otherwise
    [[nodiscard]] const std::string& name(Symbol symbol) const;
    [[nodiscard]] std::size_t size() const { return names_.size(); }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    friend bool operator==(const Alphabet& a, const Alphabet& b) { return a.names_ == b.names_; }

private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, Symbol> symbols_;
};

/// A word as the language reads it back. Letters stand side by side when every name of the alphabet is a single
/// character ("SLLSL"), else separated by blanks ("A1 A2"); `0` always stands apart ("0 0 L S 0 0").
[[nodiscard]] std::string to_string(WordView word, const Alphabet& alphabet);

/// Hash of a word, for unordered containers.
struct WordHash {
    [[nodiscard]] std::size_t operator()(const Word& word) const noexcept;
};

} // namespace internode
