// SPDX-License-Identifier: MIT

#include "internode/mask/mask_properties.h"

#include "internode/algebra/fraction.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

std::string power_of_z(std::ptrdiff_t exponent) {
    return exponent == 1 ? "z" : "z^" + std::to_string(exponent);
}

/// "-1 + 4 z - z^2"
std::string polynomial_in_z(const std::vector<Rational>& coefficients) {
    std::string text;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const Rational& coefficient = coefficients[k];
        if (coefficient == 0) continue;
        if (text.empty())
            text = coefficient < 0 ? "-" : "";
        else
            text += coefficient < 0 ? " - " : " + ";
        const Rational magnitude = abs(coefficient);
        if (k == 0 || magnitude != 1) text += to_string(magnitude) + (k == 0 ? "" : " ");
        if (k > 0) text += power_of_z(static_cast<std::ptrdiff_t>(k));
    }
    return text;
}

/// The rational that makes the coefficients integers without a common divisor, and their sum, or else the first,
/// positive, when they are divided by it.
Rational content(const std::vector<Rational>& coefficients) {
    assert(!coefficients.empty());
    Integer numerators = 0;
    Integer denominators = 1;
    Rational sum = 0;
    for (const Rational& coefficient : coefficients) {
        numerators = gcd(numerators, coefficient.get_num());
        denominators = lcm(denominators, coefficient.get_den());
        sum += coefficient;
    }
    const Rational result = fraction(numerators, denominators);
    const bool negative = sum == 0 ? coefficients.front() < 0 : sum < 0;
    return negative ? Rational(-result) : result;
}

std::string factor_text(std::size_t arity) {
    if (arity == 2) return "(1 + z)";
    if (arity == 3) return "(1 + z + z^2)";
    return "(1 + z + ... + " + power_of_z(static_cast<std::ptrdiff_t>(arity) - 1) + ")";
}

std::string symbol_text(const UniformMask& mask, std::size_t power, std::vector<Rational> quotient) {
    const Rational scale = content(quotient);
    assert(scale != 0 && "a mask has a coefficient that is not zero");
    for (Rational& coefficient : quotient) coefficient /= scale;
    std::vector<std::string> factors;
    if (mask.first != 0) factors.push_back(power_of_z(mask.first));
    if (power > 0) factors.push_back(factor_text(mask.arity) + (power > 1 ? "^" + std::to_string(power) : ""));
    if (quotient.size() > 1) factors.push_back("(" + polynomial_in_z(quotient) + ")");
    std::string text = scale == 1 && !factors.empty() ? "" : to_string(scale);
    for (const std::string& factor : factors) text += (text.empty() ? "" : " ") + factor;
    return text;
}

std::size_t residue(std::ptrdiff_t k, std::size_t arity) {
    assert(arity > 0);
    const auto m = static_cast<std::ptrdiff_t>(arity);
    return static_cast<std::size_t>(((k % m) + m) % m);
}

std::vector<Rational> class_sums(const UniformMask& mask) {
    std::vector<Rational> sums(mask.arity);
    std::ptrdiff_t k = mask.first;
    for (const Rational& coefficient : mask.coefficients) sums[residue(k++, mask.arity)] += coefficient;
    return sums;
}

bool is_interpolatory(const UniformMask& mask) {
    std::vector<std::size_t> others(mask.arity);
    std::vector<std::size_t> ones(mask.arity);
    std::ptrdiff_t k = mask.first;
    for (const Rational& coefficient : mask.coefficients) {
        const std::size_t r = residue(k++, mask.arity);
        if (coefficient == 1)
            ++ones[r];
        else if (coefficient != 0)
            ++others[r];
    }
    for (std::size_t r = 0; r < mask.arity; ++r)
        if (ones[r] == 1 && others[r] == 0) return true;
    return false;
}

/// a^{(order)}(1) = Σ a_k k(k-1)…(k-order+1), from the terms of one order less.
Rational next_derivative(std::vector<Rational>& terms, const UniformMask& mask, std::size_t order) {
    Rational sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const std::ptrdiff_t k = mask.first + static_cast<std::ptrdiff_t>(i);
        terms[i] *= Rational(k - static_cast<std::ptrdiff_t>(order) + 1);
        sum += terms[i];
    }
    return sum;
}

/// The largest d with both conditions of Conti and Hormann; the sums are known to be one and a(1) = m.
std::size_t reproduction(const UniformMask& mask, const Rational& shift, std::size_t generation) {
    assert(generation < mask.coefficients.size());
    std::vector<Rational> terms = mask.coefficients;
    Rational wanted = Rational(static_cast<unsigned long>(mask.arity));
    for (std::size_t order = 1; order <= generation; ++order) {
        wanted *= shift - Rational(static_cast<unsigned long>(order - 1));
        if (next_derivative(terms, mask, order) != wanted) return order - 1;
    }
    return generation;
}

MaskSymmetry symmetry_of(const std::vector<Rational>& coefficients) {
    if (!std::equal(coefficients.begin(), coefficients.end(), coefficients.rbegin())) return MaskSymmetry::None;
    return coefficients.size() % 2 == 1 ? MaskSymmetry::Odd : MaskSymmetry::Even;
}

} // namespace

std::optional<std::vector<Rational>> divide_by_factor(const std::vector<Rational>& coefficients, std::size_t arity) {
    if (coefficients.size() < arity) return std::nullopt;
    const std::size_t size = coefficients.size() - arity + 1;
    std::vector<Rational> quotient(size);
    assert(arity >= 1);
    Rational window = 0; // of the last arity - 1 coefficients of the quotient
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const Rational next = coefficients[k] - window;
        if (k < size)
            quotient[k] = next;
        else if (next != 0)
            return std::nullopt;
        window += next;
        if (k + 1 >= arity) window -= quotient[k + 1 - arity];
    }
    return quotient;
}

MaskProperties mask_properties(const UniformMask& mask) {
    if (mask.arity < 2 || mask.coefficients.empty())
        throw std::invalid_argument("a mask has an arity of at least 2 and a coefficient");
    MaskProperties properties;
    properties.quotient = mask.coefficients;
    while (auto divided = divide_by_factor(properties.quotient, mask.arity)) {
        properties.quotient = std::move(*divided);
        ++properties.factor_power;
    }
    properties.symbol = symbol_text(mask, properties.factor_power, properties.quotient);
    properties.sums = class_sums(mask);
    properties.sums_are_one = std::ranges::all_of(properties.sums, [](const Rational& sum) { return sum == 1; });
    if (properties.factor_power > 0) properties.generation_degree = properties.factor_power - 1;
    std::vector<Rational> terms = mask.coefficients;
    const Rational m(static_cast<unsigned long>(mask.arity));
    properties.shift = next_derivative(terms, mask, 1) / m;
    if (properties.sums_are_one)
        properties.reproduction_degree = reproduction(mask, properties.shift, *properties.generation_degree);
    properties.interpolatory = is_interpolatory(mask);
    properties.symmetry = symmetry_of(mask.coefficients);
    const std::ptrdiff_t last = mask.first + static_cast<std::ptrdiff_t>(mask.coefficients.size()) - 1;
    properties.support_first = Rational(mask.first) / (m - 1);
    properties.support_last = Rational(last) / (m - 1);
    return properties;
}

} // namespace internode
