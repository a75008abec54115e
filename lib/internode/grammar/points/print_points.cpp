// SPDX-License-Identifier: MIT

#include "internode/grammar/points/print_points.h"

#include "internode/grammar/expressions/print_expression.h"
#include "internode/grammar/lexing/name.h"

#include <cassert>
#include <span>

namespace internode {

namespace {

/// The names of the formals of letters before an arrow, taken one by one.
class FormalNames {
public:
    explicit FormalNames(std::span<const std::string> names)
        : names_(names) {}
    const std::string& next() {
        assert(used_ < names_.size());
        return names_[used_++];
    }

private:
    std::span<const std::string> names_;
    std::size_t used_ = 0;
};

std::string print_pattern(std::span<const Symbol> letters, FormalNames& formals, const PointGrammar& grammar) {
    std::string text;
    for (const Symbol letter : letters) {
        if (!text.empty()) text += ' ';
        text += letter_text(grammar, letter);
        const std::size_t arity = grammar.arity[to_index(letter)];
        for (std::size_t i = 0; i < arity; ++i) text += (i == 0 ? "(" : ", ") + formals.next();
        if (arity > 0) text += ')';
    }
    return text;
}

std::string print_modules(std::span<const ModuleTemplate> modules, std::span<const std::string> formals,
                          const PointGrammar& grammar) {
    std::string text;
    for (const ModuleTemplate& module : modules) {
        if (!text.empty()) text += ' ';
        text += letter_text(grammar, module.letter);
        const char* before = "(";
        for (const Expression& argument : module.arguments) {
            text += before + print(argument, formals, grammar);
            before = ", ";
        }
        if (!module.arguments.empty()) text += ')';
    }
    return text;
}

/// After a single letter a condition needs parentheses: `E : t > 1` would be a rule named E.
bool hides_its_condition(const PointRule& rule, const PointGrammar& grammar) {
    if (!rule.label.empty() || !rule.left.empty() || !rule.right.empty() || rule.predecessor.size() != 1) return false;
    const Symbol letter = rule.predecessor.front();
    const std::string_view name = letter_text(grammar, letter);
    return grammar.arity[to_index(letter)] == 0 && name != "#" && name.front() != '?';
}

std::string print_condition(const PointRule& rule, const PointGrammar& grammar) {
    std::string text = print(*rule.condition, rule.formals, grammar);
    return hides_its_condition(rule, grammar) && text.front() != '(' ? '(' + text + ')' : text;
}

std::string print_definition(const Definition& definition, const PointGrammar& grammar) {
    std::string text = definition.name;
    const char* before = "(";
    for (const std::string& formal : definition.formals) {
        text += before + formal;
        before = ", ";
    }
    if (!definition.formals.empty()) text += ')';
    return text + " = " + print(definition.value, definition.formals, grammar) + '\n';
}

std::string print_input(const PointInput& input, const PointGrammar& grammar) {
    const std::vector<std::string> formals{input.formal};
    std::string text = "input ";
    if (input.has_ends) text += print_modules(input.first, formals, grammar) + " | ";
    text += print_modules(input.each, formals, grammar);
    if (input.has_ends) text += " | " + print_modules(input.last, formals, grammar);
    return text + '\n';
}

/// A count is an integer, a name, or stands in parentheses.
std::string print_count(const Expression& count, const PointGrammar& grammar) {
    const std::string text = print(count, {}, grammar);
    const bool is_simple = count.code.size() == 1 && text.find_first_of("-/") == std::string::npos;
    return is_simple ? text : '(' + text + ')';
}

std::string print_cycle(const PointGrammar& grammar) {
    std::string text = "cycle";
    for (const CycleItem& item : grammar.cycle) {
        text += ' ' + grammar.tables[item.table];
        if (item.count) text += '^' + print_count(*item.count, grammar);
    }
    return text + '\n';
}

/// The rules of each table after its name; those of every table come first.
std::string print_rules(const PointGrammar& grammar) {
    std::string text;
    std::size_t tables = 0;
    const auto begin_tables = [&](std::size_t count) {
        for (; tables < count; ++tables) text += "table " + grammar.tables[tables] + '\n';
    };
    for (const PointRule& rule : grammar.rules) {
        assert(!rule.table || *rule.table < grammar.tables.size());
        if (rule.table) begin_tables(*rule.table + std::size_t{1});
        text += print(rule, grammar) + '\n';
    }
    begin_tables(grammar.tables.size());
    return text;
}

} // namespace

std::string print(const Expression& expression, std::span<const std::string> formals, const PointGrammar& grammar) {
    return print(expression, formals, std::span<const Definition>(grammar.definitions));
}

std::string print(const PointRule& rule, const PointGrammar& grammar) {
    FormalNames formals(rule.formals);
    std::string text = rule.label.empty() ? std::string() : rule.label + " : ";
    if (!rule.left.empty()) text += print_pattern(rule.left, formals, grammar) + " < ";
    text += print_pattern(rule.predecessor, formals, grammar);
    if (!rule.right.empty()) text += " > " + print_pattern(rule.right, formals, grammar);
    if (rule.condition) text += " : " + print_condition(rule, grammar);
    text += " -> ";
    text += rule.successor.empty() ? std::string(".") : print_modules(rule.successor, rule.formals, grammar);
    if (rule.weight) text += " : " + print(*rule.weight, rule.formals, grammar);
    return text;
}

std::string print(const PointGrammar& grammar) {
    std::string text = "points";
    if (!grammar.name.empty()) text += ' ' + write_grammar_name(grammar.name);
    text += '\n';
    if (grammar.ring) text += "ring\n";
    for (const Definition& definition : grammar.definitions) text += print_definition(definition, grammar);
    if (grammar.input) text += print_input(*grammar.input, grammar);
    if (grammar.axiom) text += "axiom " + print_modules(*grammar.axiom, {}, grammar) + '\n';
    if (!grammar.cycle.empty()) text += print_cycle(grammar);
    text += print_rules(grammar);
    for (const std::vector<PointRule>& pass : grammar.interpretations) {
        text += "interpretation\n";
        for (const PointRule& rule : pass) text += print(rule, grammar) + '\n';
    }
    return text;
}

} // namespace internode
