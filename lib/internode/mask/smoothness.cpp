// SPDX-License-Identifier: MIT
//
// s(z) is divided out of the symbol as often as it goes, which gives b_1 … b_L. Norms of all of them are cheap; only
// b_1, which decides convergence, and b_L, which is the sharpest, get spectral radii too. Exponents are rounded
// outwards.

#include "internode/mask/smoothness.h"

#include "internode/algebra/logarithm.h"
#include "internode/mask/mask_properties.h"

#include <algorithm>

namespace internode {

namespace {

// The logarithms err by less than 1e-14 here, the conversion of the radius by 1e-16 of it.
constexpr double logarithm_slack = 1e-12;

Rational power(const Rational& base, std::size_t exponent) {
    Rational result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

/// log_m of a value > 0, moved by `slack` unless the value is a power of m.
double logarithm(const Rational& value, std::size_t arity, double slack) {
    const Rational m(static_cast<unsigned long>(arity));
    const double estimate = decimal_logarithm(to_double(value)) / decimal_logarithm(static_cast<double>(arity));
    const auto nearest = static_cast<long>(estimate < 0 ? estimate - 0.5 : estimate + 0.5);
    const Rational exact = nearest < 0 ? Rational(1 / power(m, static_cast<std::size_t>(-nearest)))
                                       : power(m, static_cast<std::size_t>(nearest));
    return exact == value ? static_cast<double>(nearest) : estimate + slack;
}

/// b_1 … b_L.
std::vector<DifferenceScheme> difference_schemes(const UniformMask& mask, std::size_t orders) {
    const Rational m(static_cast<unsigned long>(mask.arity));
    std::vector<DifferenceScheme> schemes;
    std::vector<Rational> coefficients = mask.coefficients;
    for (std::size_t order = 1; order <= orders; ++order) {
        coefficients = *divide_by_factor(coefficients, mask.arity);
        if (order > 1)
            for (Rational& coefficient : coefficients) coefficient *= m;
        // The first differences decide convergence, the highest order is the sharpest: these two need both sides.
        const auto bounds = order == 1 || order == orders ? RadiusBounds::NormsAndSpectra : RadiusBounds::Norms;
        schemes.push_back({order, coefficients, joint_radius(coefficients, mask.arity, bounds)});
    }
    return schemes;
}

std::string contraction_text(const DifferenceScheme& scheme) {
    const std::size_t steps = *scheme.radius.contracts_after;
    std::string text = "the differences of order " + std::to_string(scheme.order) + " shrink in " +
                       std::to_string(steps) + (steps == 1 ? " step" : " steps");
    const std::string norm = to_string(scheme.radius.contraction);
    return norm.size() <= 20 ? text + " to at most " + norm : text;
}

void decide_convergence(Smoothness& result) {
    // A contraction of higher differences is one of the first: ϱ_1 is the larger of 1/m and ϱ_l m^{1-l}.
    for (const DifferenceScheme& scheme : result.differences) {
        if (!scheme.radius.contracts_after) continue;
        if (!result.derivatives) result.reason = contraction_text(scheme);
        result.convergence = SchemeConvergence::Proved;
        result.derivatives = scheme.order - 1;
    }
    if (result.convergence == SchemeConvergence::Proved) return;
    if (result.holder_lower && *result.holder_lower > 0) {
        result.convergence = SchemeConvergence::Proved;
        result.derivatives = 0;
        result.reason = "the differences of highest order shrink fast enough";
        return;
    }
    if (result.differences.front().radius.lower >= 1) {
        result.convergence = SchemeConvergence::Refuted;
        result.reason = "the first differences do not shrink: their joint spectral radius is at least 1";
        return;
    }
    result.reason = "the first differences were not seen to shrink within " +
                    std::to_string(result.differences.front().radius.steps) + " steps";
}

void bound_holder(Smoothness& result, std::size_t arity) {
    for (const DifferenceScheme& scheme : result.differences) {
        if (scheme.radius.upper == 0) continue;
        const double exponent =
            static_cast<double>(scheme.order) - 1 - logarithm(scheme.radius.upper, arity, logarithm_slack);
        if (!result.holder_lower || exponent > *result.holder_lower) result.holder_lower = exponent;
    }
    const DifferenceScheme& last = result.differences.back();
    if (last.radius.lower > 0)
        result.holder_upper =
            static_cast<double>(last.order) - 1 - logarithm(last.radius.lower, arity, -logarithm_slack);
}

/// C^n with n < exponent, when the exponent is proved.
void derivatives_from_exponent(Smoothness& result) {
    if (!result.holder_lower || *result.holder_lower <= 0) return;
    std::size_t derivatives = 0;
    while (static_cast<double>(derivatives + 1) < *result.holder_lower) ++derivatives;
    result.derivatives = std::max(result.derivatives.value_or(0), derivatives);
}

} // namespace

std::optional<Smoothness> smoothness(const UniformMask& mask) {
    const MaskProperties properties = mask_properties(mask);
    if (mask.coefficients.size() > max_smoothness_coefficients || mask.arity > max_smoothness_arity)
        return std::nullopt;
    Smoothness result;
    if (!properties.sums_are_one) {
        result.convergence = SchemeConvergence::Refuted;
        result.reason = "the sums of the mask are not 1";
        return result;
    }
    result.differences = difference_schemes(mask, properties.factor_power);
    bound_holder(result, mask.arity);
    decide_convergence(result);
    derivatives_from_exponent(result);
    result.upper_is_proved = properties.interpolatory || properties.quotient.size() == 1;
    if (result.convergence == SchemeConvergence::Refuted) {
        result.holder_lower.reset();
        result.holder_upper.reset();
    } else if (result.holder_lower && *result.holder_lower <= 0) {
        result.holder_lower.reset();
    }
    return result;
}

} // namespace internode
