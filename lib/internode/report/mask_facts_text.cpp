// SPDX-License-Identifier: MIT

#include "internode/report/mask_facts_text.h"

#include "internode/report/text_table.h"

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

std::string degree_text(const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    std::string text = properties.generation_degree
                           ? "polynomials up to degree " + std::to_string(*properties.generation_degree)
                           : "no polynomials, not even constants";
    return text;
}

std::string reproduction_text(const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    if (!properties.reproduction_degree) return "no polynomials, not even constants";
    return "polynomials up to degree " + std::to_string(*properties.reproduction_degree) + ", new point k at (k - " +
           to_string(properties.shift) + ")/" + std::to_string(facts.mask.arity);
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

std::string exponent(double value) {
    return rounded(value);
}

} // namespace

std::string convergence_text(const Smoothness& smoothness) {
    switch (smoothness.convergence) {
    case Convergence::Proved:
        return "proved: " + smoothness.reason;
    case Convergence::Refuted:
        return "none: " + smoothness.reason;
    case Convergence::NotDecided:
        break;
    }
    return "not decided: " + smoothness.reason;
}

std::string smoothness_text(const Smoothness& smoothness) {
    std::string text;
    if (smoothness.derivatives) text = "C^" + std::to_string(*smoothness.derivatives) + " proved";
    if (smoothness.holder_lower && smoothness.holder_upper && *smoothness.holder_lower == *smoothness.holder_upper) {
        text += "; Hoelder exponent " + exponent(*smoothness.holder_lower);
        return text + (smoothness.upper_is_proved ? " exactly" : ", no larger if the translates are stable");
    }
    if (smoothness.holder_lower)
        text += "; Hoelder exponent at least " + exponent(*smoothness.holder_lower) + " (proved)";
    if (smoothness.holder_upper)
        text += std::string(text.empty() ? "" : "; ") + "Hoelder exponent at most " +
                exponent(*smoothness.holder_upper) +
                (smoothness.upper_is_proved ? " (proved)" : " (if the translates are stable)");
    return text.empty() ? "nothing proved" : text;
}

std::string mask_facts_text(const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    std::string text = labelled("mask", mask_text(facts.mask));
    text += labelled("symbol", "a(z) = " + properties.symbol);
    text += labelled("arity", std::to_string(facts.mask.arity));
    text += labelled("support", "[" + to_string(properties.support_first) + ", " + to_string(properties.support_last) +
                                    "] of the limit of the unit impulse");
    text += labelled("generates", degree_text(facts));
    text += labelled("reproduces", reproduction_text(facts));
    text += labelled("interpolates", properties.interpolatory ? "yes: every old point stays" : "no");
    text += labelled("symmetric", symmetry_text(properties.symmetry));
    text += labelled("scheme", names_text(facts.known));
    if (!facts.smoothness) return text + labelled("smoothness", "the mask is too long for the bounds");
    text += labelled("convergence", convergence_text(*facts.smoothness));
    if (facts.smoothness->convergence != Convergence::Refuted)
        text += labelled("smoothness", smoothness_text(*facts.smoothness));
    return text;
}

} // namespace internode
