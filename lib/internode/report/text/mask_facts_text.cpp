// SPDX-License-Identifier: MIT

#include "internode/report/text/mask_facts_text.h"

#include "internode/report/text/text_table.h"

namespace internode {

namespace {

constexpr std::size_t listed_weights = 24;

std::string mask_text(const UniformMask& mask) {
    std::string text;
    for (std::size_t k = 0; k < mask.coefficients.size() && k < listed_weights; ++k)
        text += (k > 0 ? "  " : "") + to_string(mask.coefficients[k]);
    if (mask.coefficients.size() > listed_weights)
        text += "  ... " + std::to_string(mask.coefficients.size()) + " weights";
    const std::ptrdiff_t last = mask.first + static_cast<std::ptrdiff_t>(mask.coefficients.size()) - 1;
    return text + "  at " + std::to_string(mask.first) + " ... " + std::to_string(last);
}

std::string degree_text(std::size_t degree) {
    return degree == 0 ? "constants" : "polynomials up to degree " + std::to_string(degree);
}

/// "k/2", "(k + 1/2)/2": where the new point k stands when old points stand at the whole numbers.
std::string parameter_text(const Rational& shift, std::size_t arity) {
    const std::string below = "/" + std::to_string(arity);
    if (shift == 0) return "k" + below;
    return "(k " + std::string(shift < 0 ? "+ " : "- ") + to_string(Rational(abs(shift))) + ")" + below;
}

std::string reproduction_text(const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    if (!properties.reproduction_degree) return "nothing, not even constants";
    return degree_text(*properties.reproduction_degree) + ", with new point k at " +
           parameter_text(properties.shift, facts.mask.arity);
}

std::string symmetry_text(MaskSymmetry symmetry) {
    switch (symmetry) {
    case MaskSymmetry::Odd:
        return "yes, about a new point (odd: a primal scheme)";
    case MaskSymmetry::Even:
        return "yes, about the middle of two new points (even: a dual scheme)";
    case MaskSymmetry::None:
        break;
    }
    return "no";
}

std::string names_text(const std::vector<KnownScheme>& known) {
    std::string text;
    for (const KnownScheme& scheme : known) text += (text.empty() ? "" : "; ") + scheme.name;
    return text.empty() ? "none of those that internode knows" : text;
}

} // namespace

std::string convergence_text(const Smoothness& smoothness) {
    switch (smoothness.convergence) {
    case SchemeConvergence::Proved:
        return "proved: " + smoothness.reason;
    case SchemeConvergence::Refuted:
        return "none: " + smoothness.reason;
    case SchemeConvergence::NotDecided:
        break;
    }
    return "not decided: " + smoothness.reason;
}

std::string smoothness_text(const Smoothness& smoothness) {
    std::string text;
    if (smoothness.derivatives) text = "C^" + std::to_string(*smoothness.derivatives) + " (proved)";
    const std::string lower = smoothness.holder_lower ? rounded(*smoothness.holder_lower) : "";
    const std::string upper = smoothness.holder_upper ? rounded(*smoothness.holder_upper) : "";
    const std::string between = text.empty() ? "Hölder exponent " : "; Hölder exponent ";
    const std::string trust = smoothness.upper_is_proved ? "(proved)" : "(if the translates of the limit are stable)";
    if (!lower.empty() && lower == upper)
        return text + between + lower +
               (smoothness.upper_is_proved ? " (proved)"
                                           : " (proved; no larger if the translates of the limit are stable)");
    if (!lower.empty()) text += between + "at least " + lower + " (proved)";
    if (!upper.empty()) text += (lower.empty() ? between : ", ") + std::string("at most ") + upper + " " + trust;
    return text.empty() ? "nothing proved" : text;
}

std::string mask_facts_text(const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    std::string text = labelled("mask", mask_text(facts.mask));
    text += labelled("symbol", "a(z) = " + properties.symbol);
    text += labelled("arity", std::to_string(facts.mask.arity));
    text += labelled("support", "[" + to_string(properties.support_first) + ", " + to_string(properties.support_last) +
                                    "] of the limit of the unit impulse");
    text += labelled("generates", properties.generation_degree ? degree_text(*properties.generation_degree)
                                                               : "nothing, not even constants");
    text += labelled("reproduces", reproduction_text(facts));
    text += labelled("interpolates", properties.interpolatory ? "yes: every old point stays" : "no");
    text += labelled("symmetric", symmetry_text(properties.symmetry));
    text += labelled("scheme", names_text(facts.known));
    if (!facts.smoothness) return text + labelled("smoothness", "the mask is too long for the bounds");
    text += labelled("convergence", convergence_text(*facts.smoothness));
    if (facts.smoothness->convergence != SchemeConvergence::Refuted)
        text += labelled("smoothness", smoothness_text(*facts.smoothness));
    return text;
}

} // namespace internode
