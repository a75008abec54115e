// SPDX-License-Identifier: MIT
//
// A word after some steps of rewriting, with how many letters of each kind it has, as a document.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/report/generator.h"
#include "internode/word/morphism.h"
#include "internode/word/symbol.h"

#include <cstdint>
#include <string>

namespace internode {

struct RewrittenWord {
    Alphabet alphabet;
    Word word;
    Ends ends = Ends::Open;
    LetterCounts counts;     ///< letters of the word, by symbol
    std::uint64_t steps = 0; ///< steps of rewriting that gave the word
    Generator generator;
};

/// The word, then its counts, a symbol a line.
[[nodiscard]] std::string word_text(const RewrittenWord& word);

/// The document "internode-word" (docs/json.md), letter by letter: words are long.
void write_word_json(Sink& sink, const RewrittenWord& word);

} // namespace internode
