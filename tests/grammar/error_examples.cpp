// SPDX-License-Identifier: MIT

#include "tests/grammar/error_examples.h"

#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/parse.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace internode::tests {

namespace {

using enum ReadAs;

constexpr std::size_t megabyte = std::size_t{1} << 20;

// clang-format off
constexpr std::array examples{
    ErrorExample{"text.not-utf8", "L -> L \xFF"},
    ErrorExample{"text.control-character", "L -> L \x01"},
    ErrorExample{"text.line-too-long", "L -> L L\n//", AnyKind, 12 * megabyte - 1, "x"},
    ErrorExample{"text.too-large", "L -> L L\n", AnyKind, 16 * megabyte, " "},
    ErrorExample{"text.too-many-errors", "L -> L L\n", AnyKind, 1'001, "?\n"},

    ErrorExample{"grammar.empty", "// nothing"},
    ErrorExample{"grammar.no-kind", "axiom L\nL -> L L"},
    ErrorExample{"grammar.unknown-kind", "interval x\nL -> L L"},
    ErrorExample{"grammar.kind-to-come", "mesh loop"},
    ErrorExample{"grammar.other-kind", "points chaikin\nP(u) < P(v) -> P(u)", Intervals},
    ErrorExample{"grammar.kind-with-arrow", "points a P(v) -> P(v)"},
    ErrorExample{"grammar.second-kind", "L -> L L\nintervals x"},
    ErrorExample{"grammar.opening-goes-on", "intervals a b\nL -> L L"},
    ErrorExample{"grammar.no-rules", "intervals x"},
    ErrorExample{"grammar.no-rule", "L -> S L"},
    ErrorExample{"grammar.second-rule", "L -> L\nL -> L L"},
    ErrorExample{"grammar.unknown-statement", "L -> L L\nlenght L = 2"},
    ErrorExample{"grammar.second-statement", "L -> L L\naxiom L\naxiom L L"},
    ErrorExample{"grammar.statement-of-other-kind", "L -> L L\ntable x"},
    ErrorExample{"grammar.stands-alone", "L -> L L\naxiom L\nring L"},
    ErrorExample{"grammar.unbalanced", "L -> (L L"},
    ErrorExample{"grammar.too-many-symbols", "", AnyKind, 100'001, "A% -> A0 A0\n"},
    ErrorExample{"grammar.normal-form-too-large", "A00000000000001 -> A00000000000001^1000000"},

    ErrorExample{"name.not-a-name", "intervals my-grammar\nL -> L L"},
    ErrorExample{"name.open-quote", "intervals \"my\nL -> L L"},
    ErrorExample{"name.bad-escape", "intervals \"\\q\"\nL -> L L"},
    ErrorExample{"name.too-long", "intervals ", AnyKind, 101, "a", "\nL -> L L"},
    ErrorExample{"name.reserved", "points\nmin = 3\nE -> E"},
    ErrorExample{"name.second-parameter", "points\nP(v, v) -> P(v, v)"},
    ErrorExample{"name.unknown", "points\ntension = 1/2\nP(v) -> P(tensoin v)"},
    ErrorExample{"name.defined-later", "points\ns = 2 t\nt = 1/2\nE -> E"},
    ErrorExample{"name.uses-itself", "points\nf(x) = 2 f(x)\nE -> E"},

    ErrorExample{"rule.empty-left-side", "-> L\nL -> L L"},
    ErrorExample{"rule.not-one-symbol", "L S -> L"},
    ErrorExample{"rule.of-zero", "0 -> L L\nL -> L L"},
    ErrorExample{"rule.other-arrow", "L -> L S\nS = L"},
    ErrorExample{"rule.second-arrow", "L -> L -> S"},
    ErrorExample{"rule.empty-successor", "L ->"},
    ErrorExample{"rule.empty-part", "points\nP(u) < -> P(u)"},
    ErrorExample{"rule.second-context", "points\nA < B < C -> A"},
    ErrorExample{"rule.contexts-swapped", "points\nA > B < C -> A"},
    ErrorExample{"rule.too-many-modules", "points\n", AnyKind, 1'000, "A ", "< A -> A"},
    ErrorExample{"rule.no-parameter", "points\nP(1) -> P(1)"},
    ErrorExample{"rule.no-label", "points\n: P(v) : v < 1 -> P(v)"},
    ErrorExample{"rule.label", "points\na b : P(v) : v < 1 -> P(v)"},
    ErrorExample{"rule.third-colon", "points\na : b : c : d -> A"},
    ErrorExample{"rule.constant-as-module", "points\nn = 3\nE : n > t -> F"},
    ErrorExample{"rule.no-condition", "points\nP(v) : -> P(v)"},
    ErrorExample{"rule.no-weight", "points\nP(v) -> P(v) :"},
    ErrorExample{"rule.weight-not-positive", "points\nP(v) -> P(v) : 0"},

    ErrorExample{"word.empty", "", Word},
    ErrorExample{"word.unknown-symbol", "L T L", Word},
    ErrorExample{"word.damaged-byte", "L \xFF", Word},
    ErrorExample{"word.zero-in-rule", "L -> 0 L 0"},
    ErrorExample{"word.number", "L -> 2 L"},
    ErrorExample{"word.no-symbol", "L -> L _"},
    ErrorExample{"word.foreign-sign", "L -> L | L"},
    ErrorExample{"word.empty-parentheses", "L -> ()^2"},
    ErrorExample{"word.nested-parentheses", "L -> ((L)^2)^2"},
    ErrorExample{"word.parentheses-without-power", "L -> (L L)"},
    ErrorExample{"word.power-without-count", "L -> L^"},
    ErrorExample{"word.power-of-zero", "L -> L^0"},
    ErrorExample{"word.power-of-power", "L -> L^2^3"},
    ErrorExample{"word.power-too-large", "L -> L^1000001"},
    ErrorExample{"word.too-long", "L -> ", AnyKind, 1'000'001, "L"},
    ErrorExample{"word.symbol-too-long", "L -> L", AnyKind, 100, "1"},
    ErrorExample{"word.too-large", "", Word, 16 * megabyte + 1, "L"},

    ErrorExample{"axiom.empty", "L -> L L\naxiom"},
    ErrorExample{"axiom.sign", "L -> L L\naxiom: L"},
    ErrorExample{"axiom.missing-for-ring", "L -> L L\nring"},

    ErrorExample{"length.no-symbol", "L -> L L\nlength = 2"},
    ErrorExample{"length.no-equals", "L -> L L\nlength L 2"},
    ErrorExample{"length.no-number", "L -> L L\nlength L ="},
    ErrorExample{"length.not-a-number", "L -> L L\nlength L = x"},
    ErrorExample{"length.not-positive", "L -> L L\nlength L = 0"},
    ErrorExample{"length.contradiction", "L -> L L\nlength L = 1\nlength L = 2"},

    ErrorExample{"module.no-module", "points\nE -> 3"},
    ErrorExample{"module.statement-word", "points\nE ->\naxiom E"},
    ErrorExample{"module.no-parameter", "points\nP() -> P(1)"},
    ErrorExample{"module.other-parameters", "points\ninput P(v)\nP(u, s) < P(v) -> P(v)"},
    ErrorExample{"module.marker-with-parameters", "points\n# (v) -> #"},
    ErrorExample{"module.query-without-letter", "points\nP(v) -> ? Q(1)"},
    ErrorExample{"module.parentheses-without-letter", "points\nP(v) -> (P(v))"},
    ErrorExample{"module.empty-among-modules", "points\nP(v) -> P(v) . E"},
    ErrorExample{"module.bracket-before-arrow", "points\nP(v) [ P(v) ] -> P(v)"},
    ErrorExample{"module.branch-unbalanced", "points\nA -> B [\nC ] -> D"},
    ErrorExample{"module.power-before-arrow", "points\nE^2 -> E"},
    ErrorExample{"module.power-of-bracket", "points\nE -> [ E ]^2"},
    ErrorExample{"module.power-too-large", "points\nE -> P(", AnyKind, 140, "1", ")^90000"},
    ErrorExample{"module.too-many", "points\nE -> E^100001"},
    ErrorExample{"module.too-many-letters", "points\nE ->", AnyKind, 1'001, " A%"},
    ErrorExample{"module.too-many-parameters", "points\nE -> P(1", AnyKind, 64, ", 1", ")"},
    ErrorExample{"module.too-many-repeated-operations", "points\nP(v) -> P(v + v)^50000"},

    ErrorExample{"expression.empty", "points\nP(v) -> P(min())"},
    ErrorExample{"expression.no-value", "points\nP(v) -> P(@)"},
    ErrorExample{"expression.two-values", "points\nP(v) -> P(v 2)"},
    ErrorExample{"expression.nothing-on-left", "points\nP(v) -> P(and v)"},
    ErrorExample{"expression.nothing-on-right", "points\nP(v) -> P(v +)"},
    ErrorExample{"expression.plus-sign", "points\nP(v) -> P(+v)"},
    ErrorExample{"expression.foreign-sign", "points\nP(v) -> P(v % 2)"},
    ErrorExample{"expression.comma", "points\nA -> B [\n: 1, 2 ] -> C"},
    ErrorExample{"expression.exponent", "points\nP(v) -> P(1e-3 v)"},
    ErrorExample{"expression.ambiguous-quotient", "points\nP(a, b) -> P(a/b a, b)"},
    ErrorExample{"expression.function-without-arguments", "points\nP(v) -> P(sqrt v)"},
    ErrorExample{"expression.wrong-arity", "points\nP(v) -> P(sqrt(1, 2))"},
    ErrorExample{"expression.no-coordinate", "points\nP(v) -> P(v.q)"},
    ErrorExample{"expression.coordinate-of-number", "points\nP(v) -> P(2.x)"},
    ErrorExample{"expression.coordinate-out-of-range", "points\nP(v) -> P((1, 2).z)"},
    ErrorExample{"expression.division-by-zero", "points\nP(v) -> P(v/0)"},
    ErrorExample{"expression.division-by-point", "points\nP(v) -> P(1/(v, 2))"},
    ErrorExample{"expression.product-of-points", "points\nP(v) -> P((1, 2) (3, 4))"},
    ErrorExample{"expression.sum-of-number-and-point", "points\nP(v) -> P((v, 1) + 2)"},
    ErrorExample{"expression.point-for-number", "points\nP(v) -> P(min((1, 2), 3))"},
    ErrorExample{"expression.number-for-truth", "points\nP(v) : v + 1 -> P(v)"},
    ErrorExample{"expression.truth-for-number", "points\nP(v) : 0 < v < 1 -> P(v)"},
    ErrorExample{"expression.too-deep", "points\nP(v) -> P(", AnyKind, 201, "-", "v)"},
    ErrorExample{"expression.too-long", "points\nP(v) -> P(v", AnyKind, 50'000, "+v", ")"},
    ErrorExample{"expression.too-many-operations", "points\n", AnyKind, 45'000, "P(v) -> P(v+v+v+v+v+v+v+v+v+v+v+v+v)\n"},
    ErrorExample{"expression.too-many-digits", "points\nP(v) -> P(", AnyKind, 1'001, "1", ")"},
    ErrorExample{"expression.too-many-coordinates", "points\nE -> P((1", AnyKind, 64, ", 1", "))"},

    ErrorExample{"definition.no-value", "points\nt =\nE -> E"},
    ErrorExample{"definition.second", "points\nt = 1/2\nt = 1/3\nE -> E"},
    ErrorExample{"definition.parameters", "points\nf() = 2\nE -> E"},
    ErrorExample{"definition.too-many", "points\n", AnyKind, 10'001, "t% = 1\n", "E -> E"},
    ErrorExample{"definition.too-many-parameters", "points\nf(x", AnyKind, 64, ", x%", ") = x\nE -> E"},

    ErrorExample{"input.empty", "points\ninput\nE -> E"},
    ErrorExample{"input.empty-part", "points\ninput P(v) | | P(v)\nE -> E"},
    ErrorExample{"input.parts", "points\ninput P(v) | P(v)\nE -> E"},
    ErrorExample{"input.inner-marker", "points\ninput # P(v)\nE -> E"},
    ErrorExample{"input.point-unused", "points\ninput P(1)\nE -> E"},

    ErrorExample{"table.name", "points\ntable\nE -> E\ncycle p"},
    ErrorExample{"table.second", "points\ntable p\nE -> E\ntable p\ncycle p"},
    ErrorExample{"table.after-interpretation", "points\nE -> E\ninterpretation\ntable p\ncycle p"},
    ErrorExample{"table.too-many", "points\n", AnyKind, 1'001, "table t%\n", "E -> E\ncycle t0"},

    ErrorExample{"cycle.empty", "points\ntable p\nE -> E\ncycle"},
    ErrorExample{"cycle.missing", "points\ntable p\nE -> E"},
    ErrorExample{"cycle.without-tables", "points\ncycle p\nE -> E"},
    ErrorExample{"cycle.no-table", "points\ntable smooth\nE -> E\ncycle smoth"},
    ErrorExample{"cycle.no-count", "points\ntable p\nE -> E\ncycle p^(1/2)"},
    ErrorExample{"cycle.too-many-items", "points\ntable p\nE -> E\ncycle", AnyKind, 10'001, " p"},

    ErrorExample{"interpretation.too-many", "points\nE -> E\n", AnyKind, 1'001, "interpretation\n"},
};
// clang-format on

/// Two lines of the example that begin with blanks, so that the page shows them as they are.
std::string indented(std::string_view text) {
    std::string result;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        result += "    " + printable(text.substr(start, end - start)) + '\n';
        start = end + 1;
    }
    return result;
}

std::string shown_text(const ErrorExample& example) {
    if (example.times == 0) return indented(example.begin);
    const std::size_t last_line = example.begin.rfind('\n') + 1; // npos + 1 is 0
    const std::string_view repeated = example.repeated.substr(0, example.repeated.find('\n'));
    std::string text = indented(example.begin.substr(0, last_line));
    text += fmt::format("    {}[{} times `{}`]", example.begin.substr(last_line), example.times, repeated);
    const std::size_t end = std::min(example.end.find('\n'), example.end.size());
    return text + std::string(example.end.substr(0, end)) + '\n' +
           indented(example.end.substr(std::min(end + 1, example.end.size())));
}

std::vector<Diagnostic> read(const ErrorExample& example) {
    const std::string text = text_of(example);
    Alphabet alphabet;
    alphabet.add("L");
    alphabet.add("S");
    switch (example.read) {
    case ReadAs::Intervals:
        return parse_grammar(text, "example").errors;
    case ReadAs::Points:
        return parse_point_grammar(text, "example").errors;
    case ReadAs::Word:
        return parse_word(text, alphabet, "example").errors;
    default:
        return parse(text, "example").errors;
    }
}

/// The errors of each example, read once: some texts are of megabytes.
const std::vector<std::vector<Diagnostic>>& all_errors() {
    static const std::vector<std::vector<Diagnostic>> errors = [] {
        std::vector<std::vector<Diagnostic>> all;
        for (const ErrorExample& example : examples) all.push_back(read(example));
        return all;
    }();
    return errors;
}

std::string page_entry(const ErrorExample& example) {
    const std::vector<Diagnostic>& errors = errors_of(example);
    const auto found = std::ranges::find(errors, example.code, &Diagnostic::code);
    std::string text = fmt::format("{}\n{}", example.code, shown_text(example));
    if (found == errors.end()) return text + "    no such error\n";
    if (found->line > 0)
        text += fmt::format("    {}:{}: ", found->line, found->column);
    else
        text += "    ";
    text += printable(found->message) + '\n';
    if (!found->hint.empty()) text += "    hint: " + printable(found->hint) + '\n';
    return text;
}

} // namespace

std::span<const ErrorExample> error_examples() {
    return examples;
}

std::string text_of(const ErrorExample& example) {
    std::string text(example.begin);
    const std::size_t mark = example.repeated.find('%');
    for (std::size_t i = 0; i < example.times; ++i) {
        text += example.repeated.substr(0, mark);
        if (mark == std::string_view::npos) continue;
        text += std::to_string(i);
        text += example.repeated.substr(mark + 1);
    }
    return text += example.end;
}

const std::vector<Diagnostic>& errors_of(const ErrorExample& example) {
    return all_errors().at(static_cast<std::size_t>(&example - examples.data()));
}

std::string error_page() {
    std::string page;
    std::string_view part;
    for (const ErrorExample& example : error_examples()) {
        const std::string_view next = example.code.substr(0, example.code.find('.'));
        if (next != part) {
            page += fmt::format("{}### Errors of `{}`\n\n```text\n", part.empty() ? "" : "```\n\n", next);
        } else {
            page += '\n';
        }
        part = next;
        page += page_entry(example);
    }
    return page + "```\n";
}

} // namespace internode::tests
