// SPDX-License-Identifier: MIT

#include "internode/report/page/convergence_page.h"

#include "internode/report/markup.h"
#include "internode/report/page/convergence_plots.h"
#include "internode/report/page/page_style.h"
#include "internode/report/text/convergence_text.h"
#include "internode/report/text/text_table.h"
#include "internode/text/number.h"

namespace internode {

namespace {

constexpr std::size_t listed_rules = 12;

std::string grammar_name(const IntervalSystem& system) {
    return system.grammar().name.empty() ? "an interval grammar" : system.grammar().name;
}

std::string page_title(const ConvergencePage& page) {
    return (page.curve_name.empty() ? "A curve" : page.curve_name) + " under " + grammar_name(page.system);
}

std::string head(const ConvergencePage& page) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
           "img-src data:\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"internode " +
           markup(page.generator.version) + "\">\n<meta name=\"internode:command\" content=\"" +
           markup(page.generator.command) + "\">\n<title>" + markup(page_title(page)) + "</title>\n<style>" +
           page_style() + "</style>\n</head>\n";
}

std::string header(const ConvergencePage& page) {
    return "<header>\n<p class=\"kicker\">Convergence report · degree " + std::to_string(page.convergence.degree) +
           "</p>\n<h1>" + markup(page_title(page)) +
           "</h1>\n<p class=\"lead\">How fast the control polygon becomes the curve it controls: measured at every "
           "step, and held against what the theory guarantees.</p>\n</header>\n";
}

std::string key(std::string_view name, const std::string& value, const std::string& remark) {
    return "<div class=\"key\"><dt>" + std::string(name) + "</dt><dd>" + markup(value) + "<small>" + markup(remark) +
           "</small></dd></div>\n";
}

/// Exact text above, decimal below; the decimal alone when there is no short exact text.
std::string number_key(std::string_view name, const Number& number, const IntervalSystem& system,
                       const std::string& remark) {
    const std::string exact = exact_text(number, system.field(), system.ratio_name());
    const std::string decimal = rounded(number.to_double());
    const std::string space = remark.empty() ? "" : ", ";
    if (exact.empty() || exact == decimal) return key(name, exact.empty() ? "≈ " + decimal : exact, remark);
    return key(name, exact, "≈ " + decimal + space + remark);
}

std::string keys(const ConvergencePage& page) {
    const Convergence& convergence = page.convergence;
    const IntervalSystem& system = page.system;
    const ConvergenceStep& last = convergence.steps.back();
    std::string text = "<dl class=\"keys\">\n";
    text += key("error after " + std::to_string(last.step) + (last.step == 1 ? " step" : " steps"), rounded(last.error),
                std::to_string(last.points) + " points; at most " + rounded_up(last.envelope));
    text += number_key("expected ratio 1/" + system.ratio_name() + "²", convergence.expected_ratio, system,
                       "in the long run");
    const std::string word = to_string(convergence.constant.word, system.alphabet());
    text += number_key("constant C*", convergence.constant.value, system, word.empty() ? "" : "at " + word);
    if (convergence.depth && convergence.depth->steps)
        text += key("steps for " + rounded(convergence.depth->tolerance), std::to_string(*convergence.depth->steps),
                    convergence.depth->measured ? "guaranteed" : "extrapolated");
    return text + "</dl>\n";
}

std::string figure(const std::string& content, const std::string& caption) {
    if (content.empty()) return {};
    return "<figure>\n" + content + "<figcaption>" + caption + "</figcaption>\n</figure>\n";
}

std::string figures(const ConvergencePage& page) {
    std::string text = figure(page.picture, "The curve. Every piece between two knots has the colour and the dashes of "
                                            "its symbol; the thin line is the control polygon it started from.");
    const std::string name = markup(page.system.ratio_name());
    const std::string pair =
        figure(error_plot(page.convergence),
               "The largest distance between polygon and curve, and the envelope it can never leave. Ten times the "
               "points make a hundredth of the error: the slope is −2. Bisection halves every interval of the same "
               "curve.") +
        figure(ratio_plot(page.convergence, page.system.ratio_name()),
               "What a step leaves of the error. In the long run it is <span class=\"whole\">1/" + name + "²</span>.");
    if (!pair.empty()) text += "<div class=\"pair\">\n" + pair + "</div>\n";
    return text;
}

std::string table(const Convergence& convergence) {
    std::string text = "<h2>Step by step</h2>\n<div class=\"scroll\"><table>\n<thead><tr><th>step</th><th>points</th>"
                       "<th>largest interval</th><th>error</th><th>ratio</th><th>envelope</th></tr></thead>\n<tbody>\n";
    for (const ConvergenceStep& step : convergence.steps)
        text += "<tr><td>" + std::to_string(step.step) + "</td><td>" + std::to_string(step.points) + "</td><td>" +
                rounded(step.largest_interval) + "</td><td>" + rounded(step.error) + "</td><td>" +
                (step.ratio ? rounded(*step.ratio) : std::string("–")) + "</td><td>" + rounded_up(step.envelope) +
                "</td></tr>\n";
    return text + "</tbody></table></div>\n";
}

std::string reading(const ConvergencePage& page) {
    const std::string name = markup(page.system.ratio_name());
    std::string text = "<h2>How to read this</h2>\n";
    if (page.convergence.degree == 1)
        return text + "<p>At degree 1 the polygon is the curve: there is no error to shrink.</p>\n";
    text += "<p>A step replaces every knot interval by the word of its rule and divides the lengths by " + name +
            " ≈ " + rounded(page.system.ratio().to_double()) +
            ". The curve stays the same; its control polygon comes closer. The <em>error</em> is the largest distance "
            "between the two at the same parameter. The <em>envelope</em> is computed from the polygon alone, from the "
            "size of its corners, and the error cannot exceed it: it is what to trust when no curve is at hand.</p>\n";
    text += "<p>The constant C* says how far: after s steps the error is about C* times the largest second derivative "
            "of the curve, divided by " +
            name + " to the power 2s. It is exact, and it depends on the grammar and the degree only.</p>\n";
    if (const std::string depth = depth_sentence(page.convergence); !depth.empty())
        text += "<p>" + markup(depth) + "</p>\n";
    if (const std::string cost = bisection_sentence(page.convergence); !cost.empty())
        text += "<p>" + markup(cost) + "</p>\n";
    return text;
}

std::string grammar(const IntervalSystem& system) {
    const IntervalGrammar& source = system.grammar();
    std::string text = "<h2>The grammar</h2>\n<p>" + markup(system.ratio_name()) + " = " +
                       markup(to_string(system.ratio().to_double()));
    if (system.field().degree() > 1)
        text += ", the largest root of " + markup(polynomial_text(system.field().minimal_polynomial()));
    if (source.alphabet.size() > listed_rules) return text + ".</p>\n";
    text += ".</p>\n<div class=\"scroll\"><table>\n<thead><tr><th class=\"symbol\">symbol</th><th class=\"symbol\">"
            "rule</th><th>length</th></tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < source.alphabet.size(); ++i) {
        const Symbol symbol = to_symbol(i);
        const std::string length =
            system.occurs(symbol) ? number_text(system.length(symbol), system.field(), system.ratio_name()) : "–";
        text += "<tr><td class=\"symbol\"><code>" + markup(source.alphabet.name(symbol)) +
                "</code></td><td class=\"symbol\"><code>" +
                markup(to_string(source.rules.image(symbol), source.alphabet)) + "</code></td><td>" + markup(length) +
                "</td></tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

} // namespace

std::string convergence_page(const ConvergencePage& page) {
    return head(page) + "<body>\n<main>\n" + header(page) + keys(page) + figures(page) + table(page.convergence) +
           reading(page) + grammar(page.system) + "<footer>internode " + markup(page.generator.version) + " · <code>" +
           markup(page.generator.command) + "</code></footer>\n</main>\n</body>\n</html>\n";
}

} // namespace internode
