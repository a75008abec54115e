// SPDX-License-Identifier: MIT

#include "internode/report/text/inference_text.h"

#include "internode/grammar/points/print_points.h"
#include "internode/io/file/comment_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t shown_rows = 20; // rows of a list

std::string heading(const RowPattern& pattern, const InferenceTextOptions& options) {
    const std::size_t arity = pattern.arity();
    return fmt::format("// {}\n// {} rows, {} columns: each old point becomes {} new {}\n",
                       comment_text(options.generator.command), pattern.rows, pattern.columns, arity,
                       arity == 1 ? "one" : "ones");
}

/// `rows 1, 3, 5 and 12 more`, from 1.
std::string row_list(const std::vector<std::size_t>& rows) {
    std::vector<std::string> numbers;
    for (const std::size_t row : rows)
        if (numbers.size() < shown_rows) numbers.push_back(std::to_string(row + 1));
    std::string text = fmt::format("{} {}", rows.size() == 1 ? "row" : "rows", fmt::join(numbers, ", "));
    if (rows.size() > shown_rows) text += fmt::format(" and {} more", rows.size() - shown_rows);
    return text;
}

std::string affine_note(const RowPattern& pattern) {
    if (pattern.not_affine.empty()) return {};
    return fmt::format("// not affine: the weights of {} do not sum to 1\n", row_list(pattern.not_affine));
}

std::string shift_meaning(const RowPattern& pattern) {
    const std::size_t arity = pattern.arity();
    if (arity == 1) return "// shift d: old point i becomes new point i + d, counted from 0\n";
    return fmt::format("// shift d: old point i becomes the new points {0} i + d ... {0} i + d + {1}, counted from 0\n",
                       arity, arity - 1);
}

std::string rule_text(const PointProduction& production) {
    const PointGrammar grammar = to_grammar("", WordEnds::Ring, std::span(&production, 1));
    return print(grammar.rules.front(), grammar);
}

std::string shift_list(const RowPattern& pattern, const ShiftList& list) {
    std::string text;
    for (const std::ptrdiff_t shift : list.shifts)
        text += fmt::format("//   d = {:>2}{}  {}\n", shift, shift == list.recommended ? " *" : "  ",
                            rule_text(production_of(pattern, shift).production));
    return text + "//   * recommended: its new points lie nearest the old point that they replace\n";
}

/// The rules of a grammar as comments.
std::string commented_rules(const PointGrammar& grammar) {
    std::string text;
    for (const PointRule& rule : grammar.rules) text += fmt::format("//   {}\n", print(rule, grammar));
    return text;
}

} // namespace

std::string inference_text(const RowPattern& pattern, const InferenceTextOptions& options) {
    std::string text = heading(pattern, options) + affine_note(pattern) + shift_meaning(pattern);
    const ShiftList list = sensible_shifts(pattern);
    const std::ptrdiff_t shift = options.shift.value_or(list.recommended);
    text += options.shift ? fmt::format("// d = {}\n", shift) : shift_list(pattern, list);
    return text + print(closed_grammar(options.name, production_of(pattern, shift)));
}

std::string inference_text(const OpenPattern& pattern, const InferenceTextOptions& options) {
    const RowPattern& inner = pattern.pattern;
    std::string text = heading(inner, options) + affine_note(inner);
    text += fmt::format("// regular from row {} to row {}\n", pattern.first_regular + 1, pattern.end_regular);
    text += shift_meaning(inner);
    const ShiftList list = sensible_open_shifts(pattern);
    const std::ptrdiff_t shift = options.shift.value_or(list.recommended);
    const InferredOpenProductions inferred = open_productions(pattern, shift);
    if (!inferred.productions) throw std::invalid_argument("inference_text: no productions for this shift");
    text += options.shift ? fmt::format("// d = {}\n", shift) : shift_list(inner, list);
    const OpenProductions& productions = *inferred.productions;
    const bool is_long = options.form == OpenForm::Long;
    text += fmt::format("// right for {} points or more, in both forms; the {} one:\n", productions.least_points,
                        is_long ? "short" : "long");
    text += commented_rules(open_grammar("", productions, is_long ? OpenForm::Ordered : OpenForm::Long));
    return text + print(open_grammar(options.name, productions, options.form));
}

std::string irregular_rows_text(const InferenceProblem& problem) {
    std::string text;
    for (std::size_t i = 0; i < std::min(problem.rows.size(), shown_rows); ++i)
        text +=
            fmt::format("  row {} breaks the pattern of row {}\n", problem.rows[i].row + 1, problem.rows[i].like + 1);
    if (problem.rows.size() > shown_rows) text += fmt::format("  and {} more rows\n", problem.rows.size() - shown_rows);
    return text;
}

} // namespace internode
