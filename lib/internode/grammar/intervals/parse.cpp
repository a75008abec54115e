// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/parse.h"

#include "internode/grammar/intervals/interval_reader.h"

namespace internode {

ParsedGrammar parse_grammar(std::string_view text, std::string_view source) {
    return parse_opened<IntervalGrammar>(text, source, GrammarKind::Intervals, read_interval_grammar);
}

} // namespace internode
