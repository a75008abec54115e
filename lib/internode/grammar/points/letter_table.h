// SPDX-License-Identifier: MIT
//
// The letters of a point grammar with their numbers of parameters, as its statements use them.
//
// A module matches a module with the same letter and as many parameters; S1 (2) has both B(x) and B(x, y). So a letter
// with another number of parameters is another symbol. What is likely a mistake is refused: modules before an arrow
// that no axiom, input or successor makes, while it makes others of the same letter.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/word/symbol.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

class LetterTable {
public:
    explicit LetterTable(Complaints& complaints)
        : complaints_(complaints) {}

    enum class Use {
        Asked, ///< a rule asks for it: it stands before an arrow
        Made,  ///< an axiom, an input or a successor makes it
    };

    /// The symbol of a letter with so many parameters, added when it is new.
    Symbol use(std::string_view name, std::size_t parameters, Use use, Complaints::Place place);

    /// Says that a letter, if it is used with so many parameters, is made: P(v) by an input that is not written.
    void note_made(std::string_view name, std::size_t parameters);

    /// What only the whole grammar can tell: `Asked` symbols that nothing makes.
    void finish();

    [[nodiscard]] Alphabet letters() && { return std::move(letters_); }
    [[nodiscard]] const std::vector<std::uint32_t>& arity() const { return arity_; }

private:
    /// The name in the alphabet: `B/1` where B has another number of parameters.
    [[nodiscard]] std::string key(std::string_view name, std::size_t parameters) const;

    Complaints& complaints_;
    Alphabet letters_;
    std::vector<std::uint32_t> arity_;
    struct Origin {
        Complaints::Place place; ///< place of the first use
        bool made = false;
        std::string_view name; ///< the letter as the text has it
    };
    std::vector<Origin> origins_;
    bool full_ = false; ///< a complaint about too many letters was made
};

} // namespace internode
