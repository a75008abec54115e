// SPDX-License-Identifier: MIT
//
// From what the command line names to checked values: grammar, valid system, curve.

#pragma once

#include "cli/arguments/options.h"
#include "internode/curve/curve.h"
#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/interval/validity.h"

#include <string>

namespace internode::cli {

/// A text file or stdin, whole. \throw Failure (File, or Refused when it is too large or no text)
struct LoadedText {
    std::string text;
    std::string source;
};
[[nodiscard]] LoadedText load_text(const std::string& place);

/// The text of a grammar, for commands that take several kinds. \throw Failure as load_text; Usage for an unknown @name
[[nodiscard]] LoadedText load_grammar_text(const GrammarSource& source);

/// \throw Failure: File when it cannot be read, Refused with all its errors, Usage for an unknown @name
[[nodiscard]] IntervalGrammar load_grammar(const GrammarSource& source);
/// The same of a text that was loaded; which kind it is, kind_of(input.text) says.
[[nodiscard]] IntervalGrammar load_grammar(const LoadedText& input);
[[nodiscard]] PointGrammar load_point_grammar(const LoadedText& input);

/// A grammar that must be valid, exactly. \throw Failure as load_grammar; Refused with the verdict's reasons
[[nodiscard]] IntervalSystem load_system(const GrammarSource& source);
/// The same of a text that was loaded from `source`.
[[nodiscard]] IntervalSystem load_system(const LoadedText& input, const GrammarSource& source);

/// The word of --word. \throw Failure (Refused) with every error in it
[[nodiscard]] ParsedWord load_word(const std::string& text, const Alphabet& alphabet);

/// How a grammar is called in outputs: its own name, else the place it came from.
[[nodiscard]] std::string display_name(const std::string& name, const GrammarSource& source);
[[nodiscard]] std::string display_name(const IntervalGrammar& grammar, const GrammarSource& source);

} // namespace internode::cli
