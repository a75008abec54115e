// SPDX-License-Identifier: MIT
//
// The work is FLINT's and Arb's: factors by fmpz_poly_factor, roots by arb_fmpz_poly_complex_roots, each a ball whose
// ends become exact rationals. The classes here only own what those libraries allocate.

#include "internode/algebra/polynomial.h"

#include "internode/algebra/fraction.h"

#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <tuple>

namespace internode {

namespace {

class FlintPolynomial {
public:
    FlintPolynomial() { fmpz_poly_init(value_); }
    explicit FlintPolynomial(const Polynomial& polynomial)
        : FlintPolynomial() {
        fmpz_t coefficient;
        fmpz_init(coefficient);
        for (std::size_t i = 0; i < polynomial.size(); ++i) {
            fmpz_set_mpz(coefficient, polynomial[i].get_mpz_t());
            fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(i), coefficient);
        }
        fmpz_clear(coefficient);
    }
    FlintPolynomial(const FlintPolynomial&) = delete;
    FlintPolynomial& operator=(const FlintPolynomial&) = delete;
    ~FlintPolynomial() { fmpz_poly_clear(value_); }

    [[nodiscard]] fmpz_poly_struct* get() { return value_; }

private:
    fmpz_poly_t value_;
};

Polynomial to_polynomial(const fmpz_poly_struct* value) {
    Polynomial polynomial(static_cast<std::size_t>(fmpz_poly_length(value)));
    for (std::size_t i = 0; i < polynomial.size(); ++i) fmpz_get_mpz(polynomial[i].get_mpz_t(), value->coeffs + i);
    assert(polynomial.empty() || polynomial.back() != 0);
    return polynomial;
}

class Roots {
public:
    Roots(FlintPolynomial& polynomial, int bits)
        : size_(std::max<slong>(fmpz_poly_degree(polynomial.get()), 0))
        , values_(_acb_vec_init(size_)) {
        if (size_ > 0) arb_fmpz_poly_complex_roots(values_, polynomial.get(), 0, bits);
    }
    Roots(const Roots&) = delete;
    Roots& operator=(const Roots&) = delete;
    ~Roots() { _acb_vec_clear(values_, size_); }

    [[nodiscard]] slong size() const { return size_; }
    [[nodiscard]] acb_srcptr operator[](slong i) const { return values_ + i; }

private:
    slong size_;
    acb_ptr values_;
};

Rational to_rational(const arf_struct* value) {
    assert(arf_is_finite(value) != 0);
    fmpq_t exact;
    fmpq_init(exact);
    arf_get_fmpq(exact, value);
    Rational result;
    fmpq_get_mpq(result.get_mpq_t(), exact);
    fmpq_clear(exact);
    assert(is_canonical(result));
    return result;
}

std::pair<Rational, Rational> bounds(const arb_struct* ball) {
    arf_t end;
    arf_init(end);
    arb_get_lbound_arf(end, ball, 2 * arb_bits(ball) + 64);
    const Rational lower = to_rational(end);
    arb_get_ubound_arf(end, ball, 2 * arb_bits(ball) + 64);
    const Rational upper = to_rational(end);
    arf_clear(end);
    assert(lower <= upper);
    return {lower, upper};
}

RootBox to_box(acb_srcptr root, int bits) {
    RootBox box;
    box.real = arb_is_zero(acb_imagref(root)) != 0;
    std::tie(box.lower, box.upper) = bounds(acb_realref(root));
    arb_t modulus;
    arb_init(modulus);
    acb_abs(modulus, root, 2L * bits);
    std::tie(box.modulus_lower, box.modulus_upper) = bounds(modulus);
    arb_clear(modulus);
    return box;
}

RootBox rational_root(const Polynomial& linear) {
    assert(linear.size() == 2);
    const Rational root = fraction(-linear[0], linear[1]);
    const Rational modulus = abs(root);
    return RootBox{true, root, root, modulus, modulus};
}

} // namespace

std::vector<std::pair<Polynomial, std::size_t>> factor(const Polynomial& polynomial) {
    FlintPolynomial value(polynomial);
    if (fmpz_poly_is_zero(value.get()) != 0) throw std::invalid_argument("the zero polynomial has no factors");
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, value.get());
    std::vector<std::pair<Polynomial, std::size_t>> result;
    for (slong i = 0; i < factors->num; ++i)
        result.emplace_back(to_polynomial(factors->p + i), static_cast<std::size_t>(factors->exp[i]));
    fmpz_poly_factor_clear(factors);
    return result;
}

Polynomial characteristic_polynomial(const std::vector<std::vector<Integer>>& matrix) {
    const auto n = static_cast<slong>(matrix.size());
    for (const auto& row : matrix)
        if (row.size() != matrix.size()) throw std::invalid_argument("the matrix is not square");
    fmpz_mat_t dense;
    fmpz_mat_init(dense, n, n);
    for (slong i = 0; i < n; ++i)
        for (slong j = 0; j < n; ++j)
            fmpz_set_mpz(fmpz_mat_entry(dense, i, j),
                         matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get_mpz_t());
    FlintPolynomial result;
    fmpz_mat_charpoly(result.get(), dense);
    fmpz_mat_clear(dense);
    return to_polynomial(result.get());
}

Polynomial multiply(const Polynomial& a, const Polynomial& b) {
    FlintPolynomial left(a);
    FlintPolynomial right(b);
    fmpz_poly_mul(left.get(), left.get(), right.get());
    return to_polynomial(left.get());
}

std::vector<RootBox> roots(const Polynomial& polynomial, int bits) {
    assert(bits > 0);
    FlintPolynomial value(polynomial);
    if (fmpz_poly_is_zero(value.get()) != 0 || fmpz_poly_is_squarefree(value.get()) == 0)
        throw std::invalid_argument("only a squarefree polynomial has roots that can be isolated");
    if (fmpz_poly_degree(value.get()) == 1) return {rational_root(polynomial)};
    const Roots isolated(value, bits);
    std::vector<RootBox> boxes;
    for (slong i = 0; i < isolated.size(); ++i) boxes.push_back(to_box(isolated[i], bits));
    std::ranges::stable_sort(boxes, [](const RootBox& a, const RootBox& b) {
        return a.real != b.real ? a.real : (a.real && a.lower < b.lower);
    });
    return boxes;
}

} // namespace internode
