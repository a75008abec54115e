// SPDX-License-Identifier: MIT
//
// An automaton as flat arrays: the children of state s stand from first[s] up to first[s + 1], windows and rows one
// behind the other. Symbols are numbers from 1 on, 0 is the empty interval.

#include "internode/report/code/code_tables.h"

#include "internode/io/file/comment_text.h"
#include "internode/text/ascii.h"
#include "internode/text/number.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

std::string rules_text(const IntervalSystem& system) {
    std::string text;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        if (!text.empty()) text += ", ";
        text += system.alphabet().name(to_symbol(i)) + " -> " +
                to_string(system.rules().image(to_symbol(i)), system.alphabet());
    }
    return text;
}

std::string symbols_text(const IntervalSystem& system) {
    std::string text = "0 the empty interval";
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        text += ", ";
        text += std::to_string(i + 1) + " " + system.alphabet().name(to_symbol(i));
        if (system.occurs(to_symbol(i))) text += " of length " + to_string(system.lengths()[i].to_double());
    }
    return text;
}

std::string start_text(const std::string& start) {
    if (start == "axiom") return "the grammar's axiom and the words it becomes";
    if (start == "word") return "the word of the command and the words it becomes";
    return "closed, open and clamped words of 2d-1 intervals or more, each 2d-1 in a row among " +
           std::string(start == "all" ? "all words" : "those that persist");
}

void append_children(CodeTables& tables, const CellAutomaton& automaton) {
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s) {
        tables.first.push_back(static_cast<std::uint32_t>(tables.child.size()));
        for (const CellAutomaton::Child& child : automaton.children(s)) {
            tables.child.push_back(child.state);
            tables.row.push_back(child.row);
        }
    }
    tables.first.push_back(static_cast<std::uint32_t>(tables.child.size()));
}

/// A literal of floating type.
std::string real(double value) {
    std::string text = to_string(value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

} // namespace

std::string block_comment_text(std::string_view text) {
    std::string inert;
    for (const char c : comment_text(text)) {
        const char previous = inert.empty() ? ' ' : inert.back();
        if ((previous == '*' && c == '/') || (previous == '/' && c == '*')) inert += ' ';
        // A backslash could carry the comment's line on.
        inert += c == '\\' ? '?' : c;
    }
    return inert;
}

std::string code_identifier(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string name;
    for (const char c : text) {
        if (name.size() == longest) break;
        if (is_ascii_letter(c) || (is_ascii_digit(c) && !name.empty()))
            name += c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    if (name.empty()) return "automaton";
    return name == "gl" || name.rfind("gl_", 0) == 0 ? "g" + name : name;
}

CodeTables code_tables(const AutomatonExport& exported) {
    const StencilAutomaton& automaton = exported.automaton;
    CodeTables tables;
    tables.name = code_identifier(exported.name) + "_" + std::to_string(automaton.degree());
    tables.degree = static_cast<std::size_t>(automaton.degree());
    append_children(tables, automaton);
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s) {
        tables.lead.push_back(automaton.state(s).lead);
        for (const Symbol symbol : automaton.state(s).window)
            tables.windows.push_back(symbol == zero_interval ? 0 : static_cast<std::uint32_t>(to_index(symbol)) + 1);
    }
    assert(tables.windows.size() == tables.lead.size() * (2 * tables.degree - 1));
    return tables;
}

CodeTables code_tables(const CellExport& exported) {
    const CellAutomaton& automaton = exported.compiled.automaton();
    CodeTables tables;
    tables.name = code_identifier(exported.name);
    std::ptrdiff_t before = static_cast<std::ptrdiff_t>(automaton.width()) - 1;
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s) before = std::max(before, -automaton.offset(s));
    tables.degree = static_cast<std::size_t>(before);
    assert(before >= 0 && "an automaton has rows of at least one weight");
    append_children(tables, automaton);
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s)
        tables.lead.push_back(static_cast<std::uint32_t>(automaton.offset(s) + before));
    return tables;
}

std::string initializer(const std::vector<std::uint32_t>& values, std::size_t per_line, std::string_view suffix) {
    assert(per_line > 0);
    std::string text = "{";
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += ',';
        text += i % per_line == 0 ? "\n    " : " ";
        text += std::to_string(values[i]);
        text += suffix;
    }
    return text + "\n}";
}

std::string weight_initializer(const CellAutomaton& automaton, std::size_t width, bool nested,
                               std::string_view suffix) {
    assert(width >= automaton.width() && "rows are filled up with zeros");
    std::string text = "{";
    for (std::uint32_t row = 0; row < automaton.row_count(); ++row) {
        text += row > 0 ? ",\n    " : "\n    ";
        if (nested) text += "{";
        for (std::size_t i = 0; i < width; ++i) {
            if (i > 0) text += ", ";
            text += real(i < automaton.width() ? automaton.weights(row)[i] : 0);
            text += suffix;
        }
        if (nested) text += "}";
    }
    return text + "\n}";
}

std::string opening_comment(const AutomatonExport& exported, const Generator& generator) {
    const IntervalSystem& system = exported.system;
    const auto line = [](const std::string& text) { return " * " + block_comment_text(text) + "\n"; };
    return "/*\n" +
           line("The stencil automaton of " + exported.name + ", degree " +
                std::to_string(exported.automaton.degree()) + ", made by internode " + generator.version + ":") +
           line("    " + generator.command) + line("Rules: " + rules_text(system)) +
           line("Symbols: " + symbols_text(system)) +
           line("Ratio: " + to_string(system.ratio().to_double()) + ", which divides all lengths at every step.") +
           line("For " + start_text(exported.start) + ".");
}

std::string opening_comment(const CellExport& exported) {
    const auto line = [](const std::string& text) { return " * " + block_comment_text(text) + "\n"; };
    return "/*\n" +
           line("The cell automaton of the point grammar " + exported.name + ", made by internode " +
                exported.generator.version + ":") +
           line("    " + exported.generator.command);
}

std::string with_name(std::string_view text, std::string_view name) {
    assert(!name.empty());
    std::string result;
    for (const char c : text) {
        if (c == '@')
            result += name;
        else
            result += c;
    }
    return result;
}

} // namespace internode
