// SPDX-License-Identifier: MIT

#include "internode/grammar/parse.h"

#include "internode/grammar/intervals/interval_reader.h"
#include "internode/grammar/points/point_reader.h"

#include <cassert>

namespace internode {

namespace {

std::optional<Grammar> read_grammar(const OpenedText& opened, Complaints& complaints) {
    switch (opened.kind) {
    case GrammarKind::Intervals:
        return read_interval_grammar(opened, complaints);
    case GrammarKind::Points:
        return read_point_grammar(opened, complaints);
    }
    assert(false);
    return std::nullopt;
}

} // namespace

Parsed<Grammar> parse(std::string_view text, std::string_view source) {
    return parse_opened<Grammar>(text, source, std::nullopt, read_grammar);
}

} // namespace internode
