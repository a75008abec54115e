// SPDX-License-Identifier: MIT

#include "internode/report/rewritten_word.h"

#include <fmt/format.h>

#include <cassert>

namespace internode {

std::string word_text(const RewrittenWord& word) {
    assert(word.counts.symbols.size() == word.alphabet.size());
    std::string text = to_string(word.word, word.alphabet) + '\n';
    text += fmt::format("{} letters after {} steps\n", word.counts.total, word.steps);
    for (std::size_t i = 0; i < word.alphabet.size(); ++i)
        text += fmt::format("  {} {}\n", word.alphabet.names()[i], word.counts.symbols[i]);
    if (word.counts.zeros > 0) text += fmt::format("  0 {}\n", word.counts.zeros);
    return text;
}

} // namespace internode
