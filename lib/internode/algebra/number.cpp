// SPDX-License-Identifier: MIT
//
// The arithmetic is e-antic's: an element is a polynomial in the root, compared by enclosures of the root that are
// refined until they decide. What is kept here is the field of degree 1, which e-antic gets wrong, and the rounding.

#include "internode/algebra/number.h"

#include "internode/algebra/fraction.h"
#include "internode/algebra/polynomial.h"

#include <e-antic/renf_class.hpp>
#include <e-antic/renf_elem_class.hpp>

#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

namespace internode {

// e-antic 1.3.0 is wrong in fields of degree 1: there, and for numbers of no field, the element is a plain rational.
struct Number::Impl {
    eantic::renf_elem_class value;

    static const eantic::renf_elem_class& of(const Number& number) {
        static const eantic::renf_elem_class zero;
        return number.impl_ ? number.impl_->value : zero;
    }
    static Number make(eantic::renf_elem_class value) {
        Number number;
        number.impl_ = std::make_unique<Impl>(Impl{std::move(value)});
        return number;
    }
};

struct NumberField::Impl {
    std::vector<Integer> polynomial;
    boost::intrusive_ptr<const eantic::renf_class> field; ///< empty in degree 1
    Number generator;
};

namespace {

/// Bits of the root that a new field starts with; e-antic refines from there.
constexpr int embedding_bits = 128;

/// The real root in [lower, upper] of an irreducible polynomial of degree 2 or more.
RootBox isolate(const std::vector<Integer>& polynomial, const Rational& lower, const Rational& upper) {
    assert(polynomial.size() > 2 && lower <= upper);
    // Neither end is a root (roots are irrational), so boxes small enough are inside or outside.
    for (int bits = embedding_bits;; bits *= 2) {
        std::vector<RootBox> inside;
        bool straddles = false;
        for (const RootBox& box : roots(polynomial, bits)) {
            if (!box.real || box.upper < lower || box.lower > upper) continue;
            if (box.lower < lower || box.upper > upper) straddles = true;
            inside.push_back(box);
        }
        if (straddles) continue;
        if (inside.size() != 1) throw std::invalid_argument("the interval does not isolate one root");
        return inside.front();
    }
}

void set_dyadic(arf_struct* result, const Rational& value) {
    assert(mpz_popcount(value.get_den_mpz_t()) == 1);
    fmpz_t numerator;
    fmpz_init(numerator);
    fmpz_set_mpz(numerator, value.get_num_mpz_t());
    arf_set_fmpz(result, numerator);
    arf_mul_2exp_si(result, result, 1 - static_cast<slong>(mpz_sizeinbase(value.get_den_mpz_t(), 2)));
    fmpz_clear(numerator);
}

boost::intrusive_ptr<const eantic::renf_class> make_field(const std::vector<Integer>& polynomial, const RootBox& root) {
    assert(polynomial.size() > 2 && root.lower <= root.upper);
    arf_t lower;
    arf_t upper;
    arb_t embedding;
    fmpq_poly_t minimal;
    arf_init(lower);
    arf_init(upper);
    arb_init(embedding);
    fmpq_poly_init(minimal);
    set_dyadic(lower, root.lower);
    set_dyadic(upper, root.upper);
    arb_set_interval_arf(embedding, lower, upper, 4L * embedding_bits);
    for (std::size_t i = 0; i < polynomial.size(); ++i)
        fmpq_poly_set_coeff_mpz(minimal, static_cast<slong>(i), polynomial[i].get_mpz_t());
    renf_t field;
    renf_init(field, minimal, embedding, embedding_bits);
    auto result = eantic::renf_class::make(field, "x");
    renf_clear(field);
    fmpq_poly_clear(minimal);
    arb_clear(embedding);
    arf_clear(upper);
    arf_clear(lower);
    return result;
}

bool is_irreducible(const std::vector<Integer>& polynomial) {
    const auto factors = factor(polynomial);
    return factors.size() == 1 && factors.front().second == 1;
}

/// Applies an operation to elements of one field. A rational of another field becomes one of no field first: e-antic
/// would convert it too, but not without printing a warning.
template<typename Operation>
auto apply(const eantic::renf_elem_class& a, const eantic::renf_elem_class& b, Operation operation) {
    using Element = eantic::renf_elem_class;
    if (&a.parent() == &b.parent()) return operation(a, b);
    if (a.is_rational()) return operation(Element(static_cast<mpq_class>(a)), b);
    if (b.is_rational()) return operation(a, Element(static_cast<mpq_class>(b)));
    throw std::invalid_argument("numbers of two different fields");
}

/// Ends of a ball around the number, about 2^-bits apart.
std::pair<Rational, Rational> ball(const eantic::renf_elem_class& value, slong bits) {
    assert(bits > 0);
    arb_t approximation;
    fmpz_t lower;
    fmpz_t upper;
    fmpz_t exponent;
    arb_init(approximation);
    fmpz_init(lower);
    fmpz_init(upper);
    fmpz_init(exponent);
    renf_elem_get_arb(approximation, value.renf_elem_t(), value.parent().renf_t(), bits);
    arb_get_interval_fmpz_2exp(lower, upper, exponent, approximation);
    const slong shift = fmpz_get_si(exponent);
    std::pair<Rational, Rational> ends;
    const std::array<std::pair<fmpz*, Rational*>, 2> targets{{{lower, &ends.first}, {upper, &ends.second}}};
    for (const auto& [mantissa, end] : targets) {
        fmpz_get_mpz(end->get_num_mpz_t(), mantissa);
        if (shift >= 0)
            *end <<= static_cast<mp_bitcnt_t>(shift);
        else
            *end >>= static_cast<mp_bitcnt_t>(-shift);
    }
    fmpz_clear(exponent);
    fmpz_clear(upper);
    fmpz_clear(lower);
    arb_clear(approximation);
    assert(ends.first <= ends.second);
    return ends;
}

/// The double that both ends of a ball of the first bits round to; none where they do not, or near the ends of the
/// range, where doubles have fewer bits.
std::optional<double> nearest_normal(const eantic::renf_elem_class& value) {
    arb_t approximation;
    arf_t lower;
    arf_t upper;
    arb_init(approximation);
    arf_init(lower);
    arf_init(upper);
    renf_elem_get_arb(approximation, value.renf_elem_t(), value.parent().renf_t(), embedding_bits);
    arb_get_interval_arf(lower, upper, approximation, embedding_bits);
    const double nearest = arf_get_d(lower, ARF_RND_NEAR);
    const bool is_sure = nearest == arf_get_d(upper, ARF_RND_NEAR);
    arf_clear(upper);
    arf_clear(lower);
    arb_clear(approximation);
    const double magnitude = std::abs(nearest);
    return is_sure && magnitude > 0x1p-1000 && magnitude < 0x1p1000 ? std::optional(nearest) : std::nullopt;
}

std::string superscript(std::size_t exponent) {
    static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char digit : std::to_string(exponent)) text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

} // namespace

NumberField::NumberField() {
    static const auto rationals = std::make_shared<const Impl>(Impl{{-1, 1}, nullptr, Number(1)});
    impl_ = rationals;
}

NumberField::NumberField(const std::vector<Integer>& minimal_polynomial, const Rational& lower, const Rational& upper) {
    if (minimal_polynomial.size() < 2 || minimal_polynomial.back() != 1)
        throw std::invalid_argument("a minimal polynomial is monic and not constant");
    if (minimal_polynomial.size() == 2) {
        const Rational root(-minimal_polynomial.front());
        if (root < lower || root > upper) throw std::invalid_argument("the interval does not isolate one root");
        impl_ = std::make_shared<const Impl>(Impl{minimal_polynomial, nullptr, Number(root)});
        return;
    }
    if (!is_irreducible(minimal_polynomial)) throw std::invalid_argument("a minimal polynomial is irreducible");
    auto field = make_field(minimal_polynomial, isolate(minimal_polynomial, lower, upper));
    Number generator = Number::Impl::make(field->gen());
    impl_ = std::make_shared<const Impl>(Impl{minimal_polynomial, std::move(field), std::move(generator)});
}

std::size_t NumberField::degree() const {
    return impl_->polynomial.size() - 1;
}

const std::vector<Integer>& NumberField::minimal_polynomial() const {
    return impl_->polynomial;
}

const Number& NumberField::generator() const {
    return impl_->generator;
}

bool operator==(const NumberField& a, const NumberField& b) {
    // e-antic keeps one object for one polynomial and root.
    return a.impl_ == b.impl_ || (a.impl_->polynomial == b.impl_->polynomial && a.impl_->field == b.impl_->field);
}

Number::Number() = default;
Number::Number(Number&& other) noexcept = default;
Number& Number::operator=(Number&& other) noexcept = default;
Number::~Number() = default;

Number::Number(long value)
    : impl_(std::make_unique<Impl>(Impl{eantic::renf_elem_class(value)})) {}

Number::Number(const Rational& value)
    : impl_(std::make_unique<Impl>(Impl{eantic::renf_elem_class(value)})) {
    assert(is_canonical(value));
}

Number::Number(const NumberField& field, const std::vector<Rational>& coefficients) {
    if (coefficients.size() > field.degree())
        throw std::invalid_argument("more coefficients than the degree of the field");
    assert(std::ranges::all_of(coefficients, is_canonical));
    if (!field.impl_->field)
        *this = coefficients.empty() ? Number() : Number(coefficients.front());
    else if (!coefficients.empty())
        *this = Impl::make(eantic::renf_elem_class(*field.impl_->field, coefficients));
}

Number::Number(const Number& other)
    : impl_(other.impl_ ? std::make_unique<Impl>(*other.impl_) : nullptr) {}

Number& Number::operator=(const Number& other) {
    Number copy(other);
    impl_ = std::move(copy.impl_);
    return *this;
}

Number& Number::operator+=(const Number& other) {
    return *this = Impl::make(apply(Impl::of(*this), Impl::of(other), std::plus<>()));
}

Number& Number::operator-=(const Number& other) {
    return *this = Impl::make(apply(Impl::of(*this), Impl::of(other), std::minus<>()));
}

Number& Number::operator*=(const Number& other) {
    return *this = Impl::make(apply(Impl::of(*this), Impl::of(other), std::multiplies<>()));
}

Number& Number::operator/=(const Number& other) {
    if (other.sign() == 0) throw std::domain_error("division by zero");
    return *this = Impl::make(apply(Impl::of(*this), Impl::of(other), std::divides<>()));
}

Number Number::operator-() const {
    return Impl::make(-Impl::of(*this));
}

bool operator==(const Number& a, const Number& b) {
    return apply(Number::Impl::of(a), Number::Impl::of(b), std::equal_to<>());
}

std::strong_ordering operator<=>(const Number& a, const Number& b) {
    if (a == b) return std::strong_ordering::equal;
    const bool less = apply(Number::Impl::of(a), Number::Impl::of(b), std::less<>());
    return less ? std::strong_ordering::less : std::strong_ordering::greater;
}

int Number::sign() const {
    return Impl::of(*this).sgn();
}

bool Number::is_rational() const {
    return Impl::of(*this).is_rational();
}

std::vector<Rational> Number::coefficients(const NumberField& field) const {
    const eantic::renf_elem_class& value = Impl::of(*this);
    std::vector<Rational> result(field.degree());
    if (value.is_rational()) {
        result.front() = static_cast<mpq_class>(value);
        return result;
    }
    if (!field.impl_->field || &value.parent() != field.impl_->field.get())
        throw std::invalid_argument("a number of another field");
    const std::vector<mpz_class> numerators = value.num_vector();
    const mpz_class denominator = value.den();
    assert(denominator > 0 && numerators.size() <= result.size());
    for (std::size_t i = 0; i < numerators.size() && i < result.size(); ++i)
        result[i] = fraction(numerators[i], denominator);
    return result;
}

double Number::to_double() const {
    const eantic::renf_elem_class& value = Impl::of(*this);
    if (value.is_rational()) return internode::to_double(static_cast<mpq_class>(value));
    // Irrational, hence no tie: both ends round to the same double once they are close enough.
    if (const std::optional<double> nearest = nearest_normal(value)) return *nearest;
    for (slong bits = embedding_bits;; bits *= 2) {
        const auto [lower, upper] = ball(value, bits);
        const double nearest = internode::to_double(lower);
        if (nearest == internode::to_double(upper)) return nearest;
    }
}

std::pair<double, double> Number::enclosure() const {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nearest = to_double();
    if (nearest == infinity) return {largest, infinity};
    if (nearest == -infinity) return {-infinity, -largest};
    const std::strong_ordering order = *this <=> Number(to_rational(nearest));
    return {order < 0 ? std::nextafter(nearest, -infinity) : nearest,
            order > 0 ? std::nextafter(nearest, infinity) : nearest};
}

std::string Number::to_string(const NumberField& field, std::string_view generator) const {
    const std::vector<Rational> terms = coefficients(field);
    std::string text;
    for (std::size_t power = terms.size(); power-- > 0;) {
        const Rational& term = terms[power];
        if (term == 0) continue;
        if (term < 0)
            text += "−";
        else if (!text.empty())
            text += "+";
        const Rational magnitude = abs(term);
        if (power == 0 || magnitude != 1) text += internode::to_string(magnitude);
        if (power > 0) text += generator;
        if (power > 1) text += superscript(power);
    }
    return text.empty() ? "0" : text;
}

Number pow(const Number& value, int exponent) {
    if (exponent < 0 && value.sign() == 0) throw std::domain_error("zero to a negative power");
    Number base = exponent < 0 ? Number(1) / value : value;
    Number result(1);
    for (unsigned long rest = static_cast<unsigned long>(std::abs(static_cast<long>(exponent))); rest > 0; rest >>= 1) {
        if ((rest & 1) != 0) result *= base;
        if (rest > 1) base *= base;
    }
    return result;
}

} // namespace internode
