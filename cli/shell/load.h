// SPDX-License-Identifier: MIT
//
// From what the command line names to checked values: grammar, valid system, curve.

#pragma once

#include "cli/requests/options.h"
#include "internode/curve/curve.h"
#include "internode/grammar/grammar.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"

#include <string>

namespace internode::cli {

/// A text file or stdin, whole. \throw Failure (File, or Refused when it is too large or no text)
struct LoadedText {
    std::string text;
    std::string source;
};
[[nodiscard]] LoadedText load_text(const std::string& place);
/// The same of a file of any bytes.
[[nodiscard]] LoadedText load_bytes(const std::string& place);

/// A grammar of any kind; commands visit it, and each kind has its handlers.
struct LoadedGrammar {
    Grammar grammar;
    LoadedText text; ///< the text of the grammar: diagnostics quote it
};

/// \throw Failure: File when it cannot be read, Refused with all its errors, Usage for an unknown @name
[[nodiscard]] LoadedGrammar load_grammar(const GrammarSource& source);

/// A grammar that must be valid, exactly. \throw Failure (Refused) with the verdict's reasons
[[nodiscard]] IntervalSystem load_system(const IntervalGrammar& grammar, const GrammarSource& source);
/// The same for commands that know interval grammars alone. \throw Failure as both of the above
[[nodiscard]] IntervalSystem load_system(const GrammarSource& source);

/// The word of --word. \throw Failure (Refused) with every error in it
[[nodiscard]] ParsedWord load_word(const std::string& text, const Alphabet& alphabet);

/// How a grammar is called in outputs: its own name, else the place it came from.
[[nodiscard]] std::string display_name(const std::string& name, const GrammarSource& source);
[[nodiscard]] std::string display_name(const IntervalGrammar& grammar, const GrammarSource& source);

} // namespace internode::cli
