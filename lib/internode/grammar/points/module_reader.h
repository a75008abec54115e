// SPDX-License-Identifier: MIT
//
// From tokens to modules: letters with the tokens of their parameters, which are not read here.
//
// modules := module+; module := letter [`(` parameters `)`] [`^` count]. A letter is a symbol (letter, digits, `_`,
// `'`), `#`, `[`, `]`, or `?` and a symbol. One pass, no recursion.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/token.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

struct RawModule {
    std::string_view letter;
    Complaints::Place place;
    std::vector<std::span<const Token>> parameters; ///< each at least one token
    std::size_t power = 1;
};

enum class ModulePlace {
    Pattern,  ///< what stands before the arrow: no brackets, no powers
    Template, ///< what an axiom, an input or a successor makes: brackets have their partners
};

struct RawModules {
    std::vector<RawModule> modules;
    bool damaged = false; ///< a complaint was made; what follows it was not read
};

/// Cost: linear in the tokens.
[[nodiscard]] RawModules read_modules(std::span<const Token> tokens, ModulePlace where, std::string_view text,
                                      Complaints& complaints);

/// axiom, cycle, input, interpretation, points, ring, table: they begin statements and are no letters side by side.
[[nodiscard]] bool is_statement_word(std::string_view run);

} // namespace internode
