// SPDX-License-Identifier: MIT
//
// Declarations of lengths: `length L = 3/2`, a positive rational or decimal read exactly. A symbol may be declared
// again with the same number only.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/lexing/word_reader.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace internode {

class LengthReader {
public:
    /// All must outlive the reader.
    LengthReader(std::string_view text, const SymbolTable& symbols, Complaints& complaints)
        : text_(text)
        , symbols_(symbols)
        , complaints_(complaints) {}

    /// Reads a statement that begins with `length`. Returns the symbol's use when the symbol has no rule.
    std::optional<SymbolUse> read(const Statement& statement);
    [[nodiscard]] std::vector<LengthDeclaration> declarations() && { return std::move(declared_); }

private:
    [[nodiscard]] std::optional<Rational> read_number(std::span<const Token> tokens);
    void declare(Symbol symbol, const Rational& length, const Token& token);

    std::string_view text_;
    const SymbolTable& symbols_;
    Complaints& complaints_;
    std::vector<LengthDeclaration> declared_;
    std::unordered_map<std::size_t, std::size_t> index_; ///< where a symbol's declaration stands in declared_
};

} // namespace internode
