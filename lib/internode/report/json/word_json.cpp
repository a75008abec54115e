// SPDX-License-Identifier: MIT

#include "internode/io/json/json_writer.h"
#include "internode/report/json/json_parts.h"
#include "internode/report/rewritten_word.h"

#include <cassert>

namespace internode {

void write_word_json(Sink& sink, const RewrittenWord& word) {
    assert(word.counts.symbols.size() == word.alphabet.size());
    assert(word.counts.total == word.word.size());
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-word", word.generator);
    json.key("steps").integer(word.steps).key("circular").boolean(word.ends == Ends::Circular);
    json.key("letters").integer(word.counts.total).key("counts").begin_object();
    for (std::size_t i = 0; i < word.alphabet.size(); ++i)
        json.key(word.alphabet.names()[i]).integer(word.counts.symbols[i]);
    if (word.counts.zeros > 0) json.key("0").integer(word.counts.zeros);
    json.end_object().key("word").begin_array(JsonWriter::Layout::Line);
    for (const Symbol symbol : word.word) json.string(word.alphabet.name(symbol));
    json.end_array().end_object().finish();
}

} // namespace internode
