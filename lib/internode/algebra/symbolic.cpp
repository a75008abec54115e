// SPDX-License-Identifier: MIT
//
// A polynomial is a map from monomials to coefficients, by degree and then by variables. A quotient is not reduced:
// what divides exactly is divided, and the coefficients below are made integers without a common divisor.

#include "internode/algebra/symbolic.h"

#include "internode/algebra/fraction.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

std::uint64_t total_degree(const Monomial& monomial) {
    std::uint64_t degree = 0;
    for (const auto& [variable, exponent] : monomial) degree += exponent;
    return degree;
}

std::size_t bits(const Rational& value) {
    return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2), mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

bool within_limits(const SymbolicPolynomial& polynomial) {
    if (polynomial.size() > symbolic_limits.terms) return false;
    // The last monomial has the largest degree.
    if (!polynomial.empty() && total_degree(polynomial.rbegin()->first) > symbolic_limits.degree) return false;
    return std::ranges::all_of(polynomial,
                               [](const auto& term) { return bits(term.second) <= symbolic_limits.coefficient; });
}

Monomial multiply_monomials(const Monomial& a, const Monomial& b) {
    assert(std::ranges::is_sorted(a) && std::ranges::is_sorted(b));
    Monomial product;
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() || j != b.end()) {
        if (j == b.end() || (i != a.end() && i->first < j->first))
            product.push_back(*i++);
        else if (i == a.end() || j->first < i->first)
            product.push_back(*j++);
        else {
            product.emplace_back(i->first, i->second + j->second);
            ++i;
            ++j;
        }
    }
    return product;
}

/// a / b, when b divides a.
std::optional<Monomial> divide_monomials(const Monomial& a, const Monomial& b) {
    Monomial quotient;
    auto j = b.begin();
    for (const auto& [variable, exponent] : a) {
        if (j != b.end() && j->first < variable) return std::nullopt;
        const bool shared = j != b.end() && j->first == variable;
        if (shared && j->second > exponent) return std::nullopt;
        const std::uint32_t left = exponent - (shared ? j->second : 0);
        if (left > 0) quotient.emplace_back(variable, left);
        if (shared) ++j;
    }
    if (j != b.end()) return std::nullopt;
    return quotient;
}

/// target += factor · monomial · polynomial.
void add_multiple(SymbolicPolynomial& target, const SymbolicPolynomial& polynomial, const Rational& factor,
                  const Monomial& monomial) {
    for (const auto& [own, coefficient] : polynomial) {
        const auto place = target.try_emplace(multiply_monomials(own, monomial)).first;
        place->second += factor * coefficient;
        if (place->second == 0) target.erase(place);
    }
}

std::optional<SymbolicPolynomial> sum(const SymbolicPolynomial& a, const SymbolicPolynomial& b) {
    SymbolicPolynomial result = a;
    add_multiple(result, b, Rational(1), Monomial{});
    if (!within_limits(result)) return std::nullopt;
    return result;
}

std::optional<SymbolicPolynomial> product(const SymbolicPolynomial& a, const SymbolicPolynomial& b) {
    if (a.size() * b.size() > symbolic_limits.products) return std::nullopt;
    SymbolicPolynomial result;
    for (const auto& [monomial, coefficient] : a) add_multiple(result, b, coefficient, monomial);
    if (!within_limits(result)) return std::nullopt;
    return result;
}

/// a / b, when b divides a: the usual division by leading terms, at most as many steps as a polynomial may have terms.
std::optional<SymbolicPolynomial> exact_quotient(SymbolicPolynomial a, const SymbolicPolynomial& b) {
    SymbolicPolynomial quotient;
    assert(!b.empty());
    const auto& [leading, leading_coefficient] = *b.rbegin();
    while (!a.empty()) {
        const auto monomial = divide_monomials(a.rbegin()->first, leading);
        if (!monomial || quotient.size() == symbolic_limits.terms) return std::nullopt;
        const Rational factor = a.rbegin()->second / leading_coefficient;
        quotient.emplace(*monomial, factor);
        add_multiple(a, b, -factor, *monomial);
        if (!within_limits(a)) return std::nullopt;
    }
    return quotient;
}

/// The positive factor that makes the coefficients integers without a common divisor.
Rational primitive_factor(const SymbolicPolynomial& polynomial) {
    assert(!polynomial.empty());
    Integer numerators = 0;
    Integer denominators = 1;
    for (const auto& [monomial, coefficient] : polynomial) {
        numerators = gcd(numerators, coefficient.get_num());
        denominators = lcm(denominators, coefficient.get_den());
    }
    return fraction(denominators, numerators == 0 ? Integer(1) : numerators);
}

SymbolicPolynomial scaled(SymbolicPolynomial polynomial, const Rational& factor) {
    for (auto& [monomial, coefficient] : polynomial) coefficient *= factor;
    return polynomial;
}

bool is_constant(const SymbolicPolynomial& polynomial) {
    return polynomial.empty() || (polynomial.size() == 1 && polynomial.begin()->first.empty());
}

double evaluate_polynomial(const SymbolicPolynomial& polynomial, std::span<const double> values) {
    double result = 0;
    for (const auto& [monomial, coefficient] : polynomial) {
        assert(monomial.empty() || monomial.back().first < values.size());
        double term = to_double(coefficient);
        for (const auto& [variable, exponent] : monomial)
            for (std::uint32_t power = 0; power < exponent; ++power) term *= values[variable];
        result += term;
    }
    return result;
}

std::string monomial_text(const Monomial& monomial, std::span<const std::string> names) {
    assert(monomial.empty() || monomial.back().first < names.size());
    std::string text;
    for (const auto& [variable, exponent] : monomial) {
        text += (text.empty() ? "" : " ") + names[variable];
        if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    return text;
}

std::string polynomial_text(const SymbolicPolynomial& polynomial, std::span<const std::string> names) {
    std::vector<const SymbolicPolynomial::value_type*> terms;
    for (const auto& term : polynomial) terms.push_back(&term);
    // As people write them: t^2 before t n before n^2, though the order of monomials has the largest last.
    std::ranges::stable_sort(terms, [](const auto* a, const auto* b) {
        const auto left = total_degree(a->first);
        const auto right = total_degree(b->first);
        return left != right ? left < right : MonomialLess()(b->first, a->first);
    });
    std::string text;
    for (const auto* term : terms) {
        const Rational magnitude = abs(term->second);
        const std::string monomial = monomial_text(term->first, names);
        if (text.empty())
            text = term->second < 0 ? "-" : "";
        else
            text += term->second < 0 ? " - " : " + ";
        if (monomial.empty() || magnitude != 1) text += to_string(magnitude) + (monomial.empty() ? "" : " ");
        text += monomial;
    }
    return text.empty() ? "0" : text;
}

std::string in_parentheses(const SymbolicPolynomial& polynomial, const std::string& text) {
    return polynomial.size() > 1 || text.find_first_of(" /-") != std::string::npos ? "(" + text + ")" : text;
}

} // namespace

bool MonomialLess::operator()(const Monomial& a, const Monomial& b) const {
    const auto left = total_degree(a);
    const auto right = total_degree(b);
    if (left != right) return left < right;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        if (a[i].first != b[i].first) return a[i].first > b[i].first;
        if (a[i].second != b[i].second) return a[i].second < b[i].second;
    }
    return false; // equal degrees and one a prefix of the other: equal
}

Symbolic::Symbolic(const Rational& value) {
    if (value != 0) numerator_.emplace(Monomial{}, value);
}

Symbolic Symbolic::variable(SymbolicVariable variable) {
    Symbolic result;
    result.numerator_.emplace(Monomial{{variable, 1}}, Rational(1));
    return result;
}

Symbolic::Symbolic(SymbolicPolynomial numerator, SymbolicPolynomial denominator)
    : numerator_(std::move(numerator))
    , denominator_(std::move(denominator)) {
    assert(!denominator_.empty());
    if (numerator_.empty()) {
        denominator_ = {{Monomial{}, Rational(1)}};
        return;
    }
    if (is_constant(denominator_)) {
        numerator_ = scaled(std::move(numerator_), 1 / denominator_.begin()->second);
        denominator_ = {{Monomial{}, Rational(1)}};
        return;
    }
    if (auto quotient = exact_quotient(numerator_, denominator_)) {
        numerator_ = std::move(*quotient);
        denominator_ = {{Monomial{}, Rational(1)}};
        return;
    }
    if (auto quotient = exact_quotient(denominator_, numerator_)) {
        denominator_ = std::move(*quotient);
        numerator_ = {{Monomial{}, Rational(1)}};
    }
    Rational factor = primitive_factor(denominator_);
    if (denominator_.rbegin()->second < 0) factor = -factor;
    numerator_ = scaled(std::move(numerator_), factor);
    denominator_ = scaled(std::move(denominator_), factor);
}

std::optional<Rational> Symbolic::constant() const {
    if (!is_constant(numerator_) || !is_constant(denominator_)) return std::nullopt;
    return numerator_.empty() ? Rational(0) : numerator_.begin()->second;
}

std::vector<SymbolicVariable> Symbolic::variables() const {
    std::vector<SymbolicVariable> found;
    for (const auto* polynomial : {&numerator_, &denominator_})
        for (const auto& [monomial, coefficient] : *polynomial)
            for (const auto& [variable, exponent] : monomial) found.push_back(variable);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

double Symbolic::evaluate(std::span<const double> values) const {
    return evaluate_polynomial(numerator_, values) / evaluate_polynomial(denominator_, values);
}

Symbolic Symbolic::operator-() const {
    Symbolic result = *this;
    result.numerator_ = scaled(std::move(result.numerator_), Rational(-1));
    return result;
}

std::optional<Symbolic> add(const Symbolic& a, const Symbolic& b) {
    if (a.denominator_ == b.denominator_) {
        auto numerator = sum(a.numerator_, b.numerator_);
        if (!numerator) return std::nullopt;
        return Symbolic(std::move(*numerator), a.denominator_);
    }
    const auto left = product(a.numerator_, b.denominator_);
    const auto right = product(b.numerator_, a.denominator_);
    auto denominator = product(a.denominator_, b.denominator_);
    if (!left || !right || !denominator) return std::nullopt;
    auto numerator = sum(*left, *right);
    if (!numerator) return std::nullopt;
    return Symbolic(std::move(*numerator), std::move(*denominator));
}

std::optional<Symbolic> multiply(const Symbolic& a, const Symbolic& b) {
    auto numerator = product(a.numerator_, b.numerator_);
    auto denominator = product(a.denominator_, b.denominator_);
    if (!numerator || !denominator) return std::nullopt;
    return Symbolic(std::move(*numerator), std::move(*denominator));
}

std::optional<Symbolic> divide(const Symbolic& a, const Symbolic& b) {
    if (b.is_zero()) throw std::domain_error("a quotient by zero");
    auto numerator = product(a.numerator_, b.denominator_);
    auto denominator = product(a.denominator_, b.numerator_);
    if (!numerator || !denominator) return std::nullopt;
    return Symbolic(std::move(*numerator), std::move(*denominator));
}

std::optional<bool> identical(const Symbolic& a, const Symbolic& b) {
    const auto left = product(a.numerator(), b.denominator());
    const auto right = product(b.numerator(), a.denominator());
    if (!left || !right) return std::nullopt;
    return *left == *right;
}

std::string to_string(const Symbolic& value, std::span<const std::string> names) {
    if (is_constant(value.denominator())) return polynomial_text(value.numerator(), names);
    // Whole numbers above and below: 1/(2 n) rather than 1/2/n.
    Integer common = 1;
    for (const auto& [monomial, coefficient] : value.numerator()) common = lcm(common, coefficient.get_den());
    const SymbolicPolynomial above = scaled(value.numerator(), Rational(common));
    const SymbolicPolynomial below = scaled(value.denominator(), Rational(common));
    return in_parentheses(above, polynomial_text(above, names)) + "/" +
           in_parentheses(below, polynomial_text(below, names));
}

} // namespace internode
