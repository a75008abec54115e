// SPDX-License-Identifier: MIT

#include "internode/mask/known_schemes.h"

#include "internode/algebra/fraction.h"
#include "internode/mask/mask_properties.h"

#include <cassert>
#include <optional>

namespace internode {

namespace {

using Coefficients = std::vector<Rational>;

std::string ordinal_degree(std::size_t degree) {
    switch (degree) {
    case 1:
        return "linear ";
    case 2:
        return "quadratic ";
    case 3:
        return "cubic ";
    case 4:
        return "quartic ";
    case 5:
        return "quintic ";
    default:
        return "";
    }
}

std::string spline_name(std::size_t degree, std::size_t arity) {
    const std::string word = ordinal_degree(degree);
    std::string name = "uniform " + word + "B-spline";
    if (word.empty()) name += " of degree " + std::to_string(degree);
    return arity == 2 ? name : name + ", arity " + std::to_string(arity);
}

/// s(z)^{d+1} / m^d leaves the quotient 1/m^d.
void add_splines(const UniformMask& mask, const MaskProperties& properties, std::vector<KnownScheme>& found) {
    if (properties.quotient.size() != 1 || properties.factor_power == 0 || !properties.sums_are_one) return;
    const std::size_t degree = properties.factor_power - 1;
    const Rational parameter(static_cast<unsigned long>(degree));
    found.push_back({SchemeFamily::BSpline, {parameter}, spline_name(degree, mask.arity)});
    if (mask.arity != 2) return;
    if (degree >= 1)
        found.push_back(
            {SchemeFamily::LaneRiesenfeld, {parameter - 1}, "Lane-Riesenfeld with n = " + std::to_string(degree - 1)});
    if (degree == 2) found.push_back({SchemeFamily::Chaikin, {}, "Chaikin's corner cutting"});
}

/// p'_{2i} and p'_{2i+1} on the edge from p_{i-1} to p_i, in this order and not beyond its ends.
void add_corner_cutting(const UniformMask& mask, const MaskProperties& properties, std::vector<KnownScheme>& found) {
    if (mask.arity != 2 || mask.coefficients.size() != 4 || !properties.sums_are_one) return;
    const Rational& first = mask.coefficients[0];
    const Rational& second = mask.coefficients[1];
    if (first <= 0 || second <= first || second >= 1) return;
    found.push_back({SchemeFamily::CornerCutting,
                     {first, second},
                     "corner cutting at " + to_string(first) + " and " + to_string(second) + " of each edge"});
}

/// The new points of a binary interpolatory scheme with k weights a side, outermost first: the mask around its centre.
Coefficients interpolatory_mask(const Coefficients& half) {
    const std::size_t n = half.size();
    assert(n > 0);
    Coefficients mask(4 * n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        mask[2 * i] = half[i];
        mask[4 * n - 2 - 2 * i] = half[i];
    }
    mask[2 * n - 1] = 1;
    return mask;
}

void add_four_point(const UniformMask& mask, std::vector<KnownScheme>& found) {
    if (mask.coefficients.size() != 7) return;
    const Rational w = -mask.coefficients[0];
    if (mask.coefficients != interpolatory_mask({-w, fraction(1, 2) + w})) return;
    found.push_back({SchemeFamily::FourPoint, {w}, "4-point scheme with tension w = " + to_string(w)});
    if (w == fraction(1, 16)) found.back().name += " (Dyn, Levin and Gregory)";
}

void add_six_point(const UniformMask& mask, std::vector<KnownScheme>& found) {
    if (mask.coefficients.size() != 11) return;
    const Rational theta = mask.coefficients[0];
    const Coefficients half{theta, -fraction(1, 16) - 3 * theta, fraction(9, 16) + 2 * theta};
    if (mask.coefficients != interpolatory_mask(half)) return;
    found.push_back(
        {SchemeFamily::SixPoint, {theta}, "6-point scheme with theta = " + to_string(theta) + " (Weissman)"});
}

void add_deslauriers_dubuc(const UniformMask& mask, std::vector<KnownScheme>& found) {
    const std::size_t n = (mask.coefficients.size() + 1) / 4;
    if (n < 2 || 4 * n != mask.coefficients.size() + 1) return;
    Coefficients half = lagrange_weights(n, fraction(1, 2));
    half.resize(n);
    if (mask.coefficients != interpolatory_mask(half)) return;
    found.push_back({SchemeFamily::DeslauriersDubuc,
                     {Rational(static_cast<unsigned long>(2 * n))},
                     std::to_string(2 * n) + "-point scheme of Deslauriers and Dubuc"});
}

/// p' at 1/4 and 3/4 of each edge, on the polynomial through the 2n nearest points.
void add_dual_interpolation(const UniformMask& mask, std::vector<KnownScheme>& found) {
    const std::size_t n = mask.coefficients.size() / 4;
    if (n < 2 || 4 * n != mask.coefficients.size()) return;
    // k - 2j runs from 0 for the last point to 4n-1 for the first one.
    const Coefficients weights = lagrange_weights(n, fraction(1, 4));
    Coefficients expected(4 * n);
    for (std::size_t i = 0; i < 2 * n; ++i) {
        expected[2 * i] = weights[2 * n - 1 - i];
        expected[2 * i + 1] = weights[i];
    }
    if (mask.coefficients != expected) return;
    found.push_back({SchemeFamily::DualInterpolation,
                     {Rational(static_cast<unsigned long>(2 * n))},
                     "dual " + std::to_string(2 * n) + "-point scheme (interpolation at 1/4 and 3/4)"});
}

} // namespace

std::vector<Rational> lagrange_weights(std::size_t n, const Rational& x) {
    assert(n > 0);
    const auto last = static_cast<long>(n);
    Coefficients weights;
    for (long i = 1 - last; i <= last; ++i) {
        Rational weight = 1;
        for (long j = 1 - last; j <= last; ++j)
            if (j != i) weight *= (x - Rational(j)) / Rational(i - j);
        weights.push_back(weight);
    }
    return weights;
}

std::vector<KnownScheme> known_schemes(const UniformMask& mask) {
    const MaskProperties properties = mask_properties(mask);
    std::vector<KnownScheme> found;
    add_splines(mask, properties, found);
    add_corner_cutting(mask, properties, found);
    if (mask.arity != 2) return found;
    add_four_point(mask, found);
    add_six_point(mask, found);
    add_deslauriers_dubuc(mask, found);
    add_dual_interpolation(mask, found);
    return found;
}

} // namespace internode
