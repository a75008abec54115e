// SPDX-License-Identifier: MIT

#include "internode/input/settled_pyramid.h"

#include "internode/input/file_lengths.h"
#include "internode/input/refuse.h"
#include "internode/interval/validity.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode {

namespace {

/// The word of names of the alphabet. \throw Refused at the first that is none
Word word_of(const InputPyramid& input, const std::vector<std::string>& names, const Alphabet& alphabet) {
    Word word;
    for (const std::string& name : names) {
        const auto symbol = name == "0" ? std::optional(zero_interval) : alphabet.find(name);
        if (!symbol) refuse_all(input.source, {}, {fmt::format("`{}` is no symbol of the grammar", name)});
        word.push_back(*symbol);
    }
    return word;
}

IntervalGrammar grammar_of(const InputPyramid& input) {
    IntervalGrammar grammar;
    grammar.name = input.name;
    std::vector<std::string> problems;
    for (const InputRule& rule : input.rules) {
        if (is_symbol_name(rule.symbol))
            (void)grammar.alphabet.add(rule.symbol);
        else
            problems.push_back(fmt::format("`{}` is no name of a symbol", rule.symbol));
    }
    if (!problems.empty()) refuse_all(input.source, {}, problems);
    std::vector<Word> images;
    for (const InputRule& rule : input.rules) {
        images.push_back(word_of(input, rule.word, grammar.alphabet));
        if (images.back().empty() || std::ranges::count(images.back(), zero_interval) > 0)
            problems.push_back("`" + rule.symbol + "` has no rule that a grammar may have");
    }
    if (input.rules.empty()) problems.emplace_back("a grammar without rules");
    if (input.axiom) {
        Word word = word_of(input, input.axiom->letters, grammar.alphabet);
        if (word.empty()) problems.emplace_back("an empty axiom");
        grammar.axiom = Axiom{std::move(word), input.axiom->closed ? Ends::Circular : Ends::Open};
    }
    if (!problems.empty()) refuse_all(input.source, {}, problems);
    grammar.rules = Morphism(std::move(images));
    return grammar;
}

/// The valid system with the lengths of the file.
IntervalSystem system_of(const InputPyramid& input) {
    const Verdict verdict = validate(grammar_of(input));
    if (!verdict.system) refuse_all(input.source, {}, {"the grammar is not valid, or not known exactly"});
    FixedLengths fixed = with_lengths(*verdict.system, positive_lengths(*verdict.system, input.lengths, input.source));
    if (fixed.system) return *std::move(fixed.system);
    std::vector<std::string> messages;
    for (const LengthConflict& conflict : fixed.conflicts) messages.push_back(conflict.message);
    refuse_all(input.source, {}, messages);
}

/// The parameter where the coarse polygon begins.
Number origin_of(const InputPyramid& input, const IntervalSystem& system) {
    InputPolygon side;
    side.source = input.source;
    side.origin = input.origin;
    return file_origin(system, side, {});
}

} // namespace

Settled<Pyramid> settle_pyramid(const InputPyramid& input) {
    assert(input.dimension >= 1 && input.degree <= static_cast<std::size_t>(max_degree));
    return settled([&] {
        const IntervalSystem system = system_of(input);
        CurveData data;
        data.degree = static_cast<int>(input.degree);
        data.ends = input.word.closed ? Ends::Circular : Ends::Open;
        data.word = word_of(input, input.word.letters, system.alphabet());
        data.dimension = input.dimension;
        data.points = input.points;
        data.origin = origin_of(input, system);
        CheckedCurve curve = make_curve(system, std::move(data));
        if (!curve.curve) refuse_all(input.source, {}, curve.problems);
        CheckedPyramid checked = make_pyramid(*std::move(curve.curve), input.options, input.levels);
        if (!checked.pyramid) refuse_all(input.source, {}, checked.problems);
        return *std::move(checked.pyramid);
    });
}

} // namespace internode
