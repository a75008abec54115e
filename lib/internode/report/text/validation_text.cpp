// SPDX-License-Identifier: MIT

#include "internode/report/text/validation_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/number.h"
#include "internode/text/printable.h"

#include <cassert>
#include <numeric>

namespace internode {

namespace {

constexpr std::size_t listed_rules = 12;
constexpr std::size_t listed_symbols = 8; // symbols of a class

std::string_view decision_text(Decision decision) {
    switch (decision) {
    case Decision::Valid:
        return "valid";
    case Decision::Invalid:
        return "not valid";
    case Decision::Undecided:
        break;
    }
    return "undecided";
}

std::string rules_text(const IntervalGrammar& grammar) {
    if (grammar.alphabet.size() > listed_rules) return std::to_string(grammar.alphabet.size()) + " rules";
    std::string text;
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i) {
        if (i > 0) text += ",  ";
        text += grammar.alphabet.name(to_symbol(i)) + " -> " +
                to_string(grammar.rules.image(to_symbol(i)), grammar.alphabet);
    }
    return printable(text);
}

std::string ratio_text(const Verdict& verdict) {
    const std::string name = ratio_name(verdict);
    if (verdict.field && verdict.field->degree() == 1 && verdict.ratio.exact)
        return name + " = " + verdict.ratio.exact->to_string(*verdict.field, name);
    if (!verdict.field) return name + " ≈ " + to_string(verdict.ratio.value);
    return name + " ≈ " + to_string(verdict.ratio.value) + ", the largest root of " +
           polynomial_text(verdict.field->minimal_polynomial());
}

std::string theorems_text(const Verdict& verdict) {
    std::string text;
    for (const std::string& theorem : verdict.theorems) {
        if (theorem == "criterion")
            return "the full criterion: the final classes are the basic ones, and the ratio is above 1";
        text += text.empty() ? "" : " and ";
        text += (theorem == "3.8" ? "corollary " : "theorem ") + theorem;
    }
    return text + " of Nivoliers et al. 2012";
}

std::string period_text(std::size_t period) {
    return std::to_string(period) + (period == 1 ? " (every step alike)" : " (imprimitive: the steps cycle)");
}

std::string quantity_text(const Quantity& quantity, const Verdict& verdict) {
    if (quantity.exact && verdict.field) return number_text(*quantity.exact, *verdict.field, ratio_name(verdict));
    return "≈ " + rounded(quantity.value);
}

/// A class's ratio may lie in a field of its own: the decimal is what a reader compares.
std::string class_ratio_text(const Quantity& quantity) {
    if (quantity.exact && quantity.exact->is_rational()) return quantity.exact->to_string(NumberField(), "");
    return "≈ " + rounded(quantity.value);
}

std::string symbols_table(const Verdict& verdict, const IntervalGrammar& grammar) {
    const Alphabet& alphabet = grammar.alphabet;
    assert(verdict.occurs.size() == alphabet.size() && verdict.lengths.size() == alphabet.size());
    TextTable table({Align::Left, Align::Left, Align::Left}, 2, 4);
    const bool has_frequencies = !verdict.frequencies.empty();
    table.row({"symbol", "length", has_frequencies ? "frequency" : ""});
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        const std::string name = printable(alphabet.name(to_symbol(i)));
        if (verdict.occurs[i])
            table.row({name, quantity_text(verdict.lengths[i], verdict),
                       has_frequencies ? quantity_text(verdict.frequencies[i], verdict) : ""});
        else
            table.row({name, "the axiom never produces it"});
    }
    std::string text = "\n" + table.text();
    if (!has_frequencies)
        text += grammar.axiom ? "  The frequencies are not known: their bounds do not come close enough.\n"
                              : "  Frequencies depend on the axiom, and the grammar has none.\n";
    return text;
}

std::string class_name(const std::vector<Symbol>& symbols, const Alphabet& alphabet) {
    std::string text = "{";
    for (std::size_t i = 0; i < symbols.size() && i < listed_symbols; ++i)
        text += (i > 0 ? " " : "") + printable(alphabet.name(symbols[i]));
    if (symbols.size() > listed_symbols) text += " … " + std::to_string(symbols.size()) + " symbols";
    return text + "}";
}

std::string classes_table(const Verdict& verdict, const Alphabet& alphabet) {
    TextTable table({Align::Left, Align::Left, Align::Left, Align::Left, Align::Right}, 2, 4);
    table.row({"class", "its ratio", "final", "basic", "period"});
    const auto answer = [](bool yes) { return std::string(yes ? "yes" : "no"); };
    for (const SymbolClass& symbol_class : verdict.classes)
        table.row({class_name(symbol_class.symbols, alphabet), class_ratio_text(symbol_class.ratio),
                   answer(symbol_class.final), symbol_class.basic ? answer(*symbol_class.basic) : "?",
                   symbol_class.period == 0 ? "-" : std::to_string(symbol_class.period)});
    return "\n" + table.text();
}

} // namespace

std::string ratio_name(const Verdict& verdict) {
    if (verdict.system) return verdict.system->ratio_name();
    return "ρ";
}

std::string validation_text(const Verdict& verdict, const IntervalGrammar& grammar) {
    std::string text = grammar.name.empty() ? "The system" : printable(grammar.name);
    text += grammar.name.empty() ? " is " : ": ";
    text += std::string(decision_text(verdict.decision)) + "\n";
    for (const Reason& reason : verdict.reasons) text += "  - " + wrapped(printable(reason.message), 4) + "\n";
    text += "\n" + labelled("rules", rules_text(grammar));
    if (grammar.axiom) {
        const std::string word = printable(to_string(grammar.axiom->word, grammar.alphabet));
        text += labelled("axiom", grammar.axiom->ends == Ends::Circular ? "(" + word + "), closed" : word);
    }
    text += labelled("ratio", ratio_text(verdict));
    text += labelled("enclosure",
                     "[" + to_string(verdict.ratio.bounds.lower) + ", " + to_string(verdict.ratio.bounds.upper) + "]");
    if (verdict.decision == Decision::Valid) {
        text += labelled("valid by", theorems_text(verdict));
        text += labelled("period", period_text(verdict.period));
        if (verdict.pisot) text += labelled("Pisot number", *verdict.pisot ? "yes" : "no");
        text += labelled("free lengths", std::to_string(verdict.free_lengths));
        if (!verdict.lengths.empty()) text += symbols_table(verdict, grammar);
    }
    text += classes_table(verdict, grammar.alphabet);
    return text;
}

} // namespace internode
