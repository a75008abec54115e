// SPDX-License-Identifier: MIT
//
// The third step of reading: from the tokens of a word to letters.
//
// word := item+; item := (symbol | `0` | `(` word without parentheses `)`) [`^` count]. Powers are written out, their
// size is checked before. One pass, no recursion: parentheses have one level.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/token.h"
#include "internode/word/symbol.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

/// Symbols by name, one-letter names without hashing.
class SymbolTable {
public:
    /// The alphabet must outlive the table and not change.
    explicit SymbolTable(const Alphabet& alphabet);
    [[nodiscard]] std::optional<Symbol> find(std::string_view name) const;

private:
    const Alphabet* alphabet_;
    std::array<std::optional<Symbol>, 128> single_{};
};

enum class WordPlace {
    Rule,  ///< no `0`, no circle
    Axiom, ///< `0` is a letter; `( … )` round the whole word makes it circular
};

struct WordContext {
    std::string_view text;
    const SymbolTable& symbols;
    WordPlace place = WordPlace::Axiom;
    std::size_t max_letters = 0; ///< most letters of this word
    std::size_t used = 0;        ///< letters of the words before it, of max_word_letters in all
};

struct SymbolUse {
    std::string_view name;
    std::size_t offset = 0;
};

struct ReadWord {
    Word word;
    Ends ends = Ends::Open;
    bool damaged = false;           ///< a complaint was made
    std::vector<SymbolUse> unknown; ///< the first use of each name that is no symbol; word lacks them
};

/// Reads at least one token. Syntax beyond the first offence is not judged.
[[nodiscard]] ReadWord read_word(std::span<const Token> tokens, const WordContext& context, Complaints& complaints);

/// The length of the symbol at the start of a run: a letter and the digits, `_` and `'` after it; 0 if it begins
/// otherwise.
[[nodiscard]] std::size_t symbol_length(std::string_view run);

/// The refusal of a name beyond max_name_bytes.
[[nodiscard]] std::string too_long_symbol(std::string_view name);

} // namespace internode
