// SPDX-License-Identifier: MIT
//
// In the derivation a rule waits for its letters: each letter that becomes known counts down the rules that wait for
// it, and a rule at 0 is applied, once. An interpretation pass reads one layout and writes another, so one round over
// its rules is enough.

#include "internode/point/layouts.h"

#include "internode/expression/type.h"
#include "internode/point/effective_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// What made a letter known, for messages.
struct Origin {
    enum class Source { Input, Axiom, Rule, Identity } source = Source::Input;
    const PointRule* rule = nullptr;
};

std::string text_of(const Origin& origin) {
    switch (origin.source) {
    case Origin::Source::Input:
        return "in the input";
    case Origin::Source::Axiom:
        return "in the axiom";
    case Origin::Source::Identity:
        return "where no rule rewrites it";
    default:
        return origin.rule->label.empty() ? "in an earlier rule" : fmt::format("in rule `{}`", origin.rule->label);
    }
}

std::vector<Symbol> letters_of(const PointRule& rule) {
    std::vector<Symbol> letters = rule.left;
    letters.insert(letters.end(), rule.predecessor.begin(), rule.predecessor.end());
    letters.insert(letters.end(), rule.right.begin(), rule.right.end());
    return letters;
}

/// A layout that grows, and the rules that wait for letters of `read`, which may be the same layout.
class LayoutMaker {
public:
    LayoutMaker(const PointGrammar& grammar, std::vector<PointProblem>& problems)
        : grammar_(grammar)
        , problems_(problems)
        , layout_(grammar.letters.size())
        , origins_(grammar.letters.size()) {}

    Layout take() { return std::move(layout_); }

    void add_word(std::span<const ModuleTemplate> modules, const Formals& formals, const Origin& origin) {
        for (const ModuleTemplate& one : modules) add_module(one, formals, origin);
    }

    void learn(Symbol letter, std::vector<Extent> extents, const Origin& origin) {
        assert(!layout_[to_index(letter)]);
        layout_[to_index(letter)] = std::move(extents);
        origins_[to_index(letter)] = origin;
        learnt_.push_back(letter);
    }

    /// All rules whose letters are in `read`, once each.
    void apply(std::span<const PointRule> rules, const Layout& read) {
        for (const PointRule& rule : rules) apply(rule, read);
    }

    /// The same where the layout that grows is the one that is read.
    void close_under(std::span<const PointRule> rules) {
        std::vector<std::size_t> missing(rules.size());
        std::vector<std::vector<std::size_t>> waiting(layout_.size());
        for (std::size_t i = 0; i < rules.size(); ++i) {
            std::vector<Symbol> letters = letters_of(rules[i]);
            std::ranges::sort(letters);
            letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
            missing[i] = letters.size();
            for (const Symbol letter : letters) waiting[to_index(letter)].push_back(i);
        }
        while (!learnt_.empty()) {
            const Symbol letter = learnt_.back();
            learnt_.pop_back();
            for (const std::size_t i : waiting[to_index(letter)])
                if (--missing[i] == 0) apply(rules[i], layout_);
        }
    }

private:
    void apply(const PointRule& rule, const Layout& read) {
        std::vector<Extent> extents;
        for (const Symbol letter : letters_of(rule)) {
            const auto& parameters = read[to_index(letter)];
            if (!parameters) return;
            extents.insert(extents.end(), parameters->begin(), parameters->end());
        }
        const Formals formals{rule.formals, extents};
        if (rule.condition)
            expect_type({true, 0}, "the condition", *rule.condition, formals, grammar_.definitions, problems_);
        if (rule.weight) expect_type({}, "the weight", *rule.weight, formals, grammar_.definitions, problems_);
        add_word(rule.successor, formals, {Origin::Source::Rule, &rule});
    }

    void add_module(const ModuleTemplate& one, const Formals& formals, const Origin& origin) {
        std::vector<Extent> extents;
        for (const Expression& argument : one.arguments) {
            const std::optional<ExpressionType> type = type_of(argument, formals, grammar_.definitions, problems_);
            if (type && type->truth) problems_.push_back({argument.place, "a parameter cannot be a truth", ""});
            if (type && !type->truth) extents.push_back(type->extent);
        }
        if (extents.size() != one.arguments.size()) return;
        if (layout_[to_index(one.letter)])
            compare(one, extents);
        else
            learn(one.letter, std::move(extents), origin);
    }

    void compare(const ModuleTemplate& one, std::span<const Extent> extents) {
        const std::vector<Extent>& known = *layout_[to_index(one.letter)];
        assert(extents.size() == known.size() && "a letter has one number of parameters");
        for (std::size_t i = 0; i < extents.size(); ++i) {
            if (extents[i] == known[i]) continue;
            problems_.push_back({one.arguments[i].place,
                                 fmt::format("parameter {} of `{}` is {} here, but {} {}", i + 1,
                                             letter_text(grammar_, one.letter), describe({false, extents[i]}),
                                             describe({false, known[i]}), text_of(origins_[to_index(one.letter)])),
                                 "a parameter is a number everywhere or a point of so many coordinates everywhere"});
        }
    }

    const PointGrammar& grammar_;
    std::vector<PointProblem>& problems_;
    Layout layout_;
    std::vector<Origin> origins_;
    std::vector<Symbol> learnt_;
};

void add_input(const PointInput& input, std::size_t dimension, LayoutMaker& maker) {
    const std::vector<std::string> names{input.formal};
    const std::vector<Extent> extents{static_cast<Extent>(dimension)};
    const Formals formals{names, extents};
    for (const auto* part : {&input.first, &input.each, &input.last})
        maker.add_word(*part, formals, {Origin::Source::Input, nullptr});
}

Layout derivation_layout(const PointGrammar& grammar, const PointSettings& settings,
                         std::vector<PointProblem>& problems) {
    LayoutMaker maker(grammar, problems);
    const std::optional<PointInput> input = effective_input(grammar, settings.start);
    const bool has_axiom = grammar.axiom && settings.start != PointStart::Input;
    if (has_axiom) maker.add_word(*grammar.axiom, {}, {Origin::Source::Axiom, nullptr});
    if (input) add_input(*input, settings.dimension, maker);
    if (!has_axiom && !input) {
        const bool axiom = settings.start == PointStart::Axiom;
        problems.push_back({{},
                            axiom ? "the grammar has no axiom" : "nothing says what the points of a polygon become",
                            axiom ? "begin a statement with `axiom`"
                                  : "there is no `P(v)`: write `input …` with a letter of the grammar, or an axiom"});
    }
    maker.close_under(grammar.rules);
    return maker.take();
}

/// Whether the rule rewrites every module of its letter.
bool always_applies(const PointRule& rule) {
    return rule.left.empty() && rule.right.empty() && !rule.condition && rule.predecessor.size() == 1;
}

Layout interpreted_layout(const PointGrammar& grammar, const Layout& before, std::span<const PointRule> rules,
                          std::vector<PointProblem>& problems) {
    LayoutMaker maker(grammar, problems);
    std::vector<bool> rewritten(before.size(), false);
    for (const PointRule& rule : rules)
        if (always_applies(rule)) rewritten[to_index(rule.predecessor.front())] = true;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i] && !rewritten[i]) maker.learn(to_symbol(i), *before[i], {Origin::Source::Identity, nullptr});
    maker.apply(rules, before);
    return maker.take();
}

} // namespace

std::vector<Layout> infer_layouts(const PointGrammar& grammar, const PointSettings& settings,
                                  std::vector<PointProblem>& problems) {
    std::vector<Layout> layouts{derivation_layout(grammar, settings, problems)};
    for (const std::vector<PointRule>& pass : grammar.interpretations)
        layouts.push_back(interpreted_layout(grammar, layouts.back(), pass, problems));
    return layouts;
}

} // namespace internode
