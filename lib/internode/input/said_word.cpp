// SPDX-License-Identifier: MIT

#include "internode/input/said_word.h"

#include "internode/curve/knots.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/input/file_lengths.h"
#include "internode/input/refuse.h"

#include <fmt/format.h>

namespace internode {

namespace {

/// The word that the JSON gives, as an array of names or as a text.
std::optional<SaidWord> file_word(const InputPolygon& file, const Alphabet& alphabet, const Wording& wording) {
    SaidWord said{{}, wording.thing + " word"};
    if (file.word_text) {
        ParsedWord word = parse_word(file.word_text->text, alphabet, file.source + ": \"word\"");
        if (!word.errors.empty()) refuse(std::move(word.errors));
        said.axiom = std::move(word.axiom);
        return said;
    }
    if (!file.word_letters) return std::nullopt;
    std::vector<Diagnostic> errors;
    for (const PlacedText& letter : *file.word_letters) {
        const auto symbol = letter.text == "0" ? std::optional(zero_interval) : alphabet.find(letter.text);
        if (symbol)
            said.axiom.word.push_back(*symbol);
        else
            errors.push_back(unknown_symbol(letter, file.source, alphabet));
    }
    if (!errors.empty()) refuse(std::move(errors));
    return said;
}

} // namespace

int settled_degree(const std::optional<int>& said, const InputPolygon& file, const Wording& wording) {
    const auto& given = file.degree;
    if (!said && !given) ask(fmt::format("no degree{}", wording.after), wording.degree_hint);
    if (said && given && static_cast<std::size_t>(*said) != *given)
        refuse(fmt::format("{} {}{} disagrees with \"degree\": {} of {}", wording.after.empty() ? "-d" : "degree",
                           *said, wording.after, *given, file.source));
    if (said) return *said;
    if (*given < 1 || *given > max_degree)
        refuse(fmt::format("\"degree\": {}{} of {} is not between 1 and {}", *given, wording.after, file.source,
                           max_degree));
    return static_cast<int>(*given);
}

SaidWord callers_word(const std::string& text, const Alphabet& alphabet, const Wording& wording) {
    ParsedWord word = parse_word(text, alphabet, "<word>");
    if (!word.errors.empty()) refuse(std::move(word.errors));
    return {std::move(word.axiom), wording.option};
}

SaidWord settled_word(const IntervalSystem& system, const std::string& said, const InputPolygon& file,
                      std::size_t points, const Wording& wording) {
    if (!said.empty()) return callers_word(said, system.alphabet(), wording);
    const std::optional<Axiom>& axiom = system.grammar().axiom;
    std::optional<SaidWord> word = file_word(file, system.alphabet(), wording);
    if (word && axiom && word->axiom.word != axiom->word)
        refuse(fmt::format("{}{} word ({} letters) and the grammar's axiom ({} letters) disagree", wording.before,
                           wording.thing, word->axiom.word.size(), axiom->word.size()),
               fmt::format("say which one is meant with {}", wording.option));
    if (word) return *std::move(word);
    if (axiom) return {*axiom, "the axiom"};
    refuse(fmt::format("no word for the {} points of {}{}", points, file.source, wording.after),
           fmt::format("name the knot intervals, for example {} '{}' --repeat", wording.option,
                       to_string(Word{to_symbol(0)}, system.alphabet())));
}

bool says_circular(const SaidWord& word) {
    return word.axiom.ends == Ends::Circular;
}

} // namespace internode
