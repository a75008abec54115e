// SPDX-License-Identifier: MIT

#include "internode/interval/eigenvector.h"

#include "internode/algebra/polynomial.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

using IntegerVector = std::vector<Integer>;

/// The quotient by a monic polynomial, whose remainder replaces `dividend`.
Polynomial divide(Polynomial& dividend, const Polynomial& divisor) {
    assert(divisor.back() == 1);
    Polynomial quotient;
    while (dividend.size() >= divisor.size()) {
        const Integer factor = dividend.back();
        const std::size_t shift = dividend.size() - divisor.size();
        for (std::size_t i = 0; factor != 0 && i < divisor.size(); ++i) dividend[shift + i] -= factor * divisor[i];
        quotient.push_back(factor);
        dividend.pop_back();
    }
    std::ranges::reverse(quotient);
    return quotient;
}

IntegerVector multiply(const SparseMatrix& block, const IntegerVector& vector) {
    assert(vector.size() == block.size());
    IntegerVector result(block.size());
    for (std::size_t i = 0; i < block.size(); ++i)
        for (const auto& [column, entry] : block[i]) result[i] += vector[column] * entry;
    return result;
}

/// c v + M u.
IntegerVector horner(const SparseMatrix& block, const IntegerVector& u, const Integer& c, const IntegerVector& v) {
    assert(v.size() == block.size());
    IntegerVector result = multiply(block, u);
    for (std::size_t i = 0; i < v.size(); ++i) result[i] += c * v[i];
    return result;
}

/// h(M) v.
IntegerVector apply(const Polynomial& h, const SparseMatrix& block, const IntegerVector& v) {
    IntegerVector result(v.size());
    for (std::size_t t = h.size(); t-- > 0;) result = horner(block, result, h[t], v);
    return result;
}

/// u_0 … u_{d-1} with f(x) − f(M) = (x − M) Σ_t x^t u_t for f monic of degree d, each applied to v.
std::vector<IntegerVector> difference_quotient(const Polynomial& f, const SparseMatrix& block, const IntegerVector& v) {
    assert(f.size() >= 2 && f.back() == 1);
    std::vector<IntegerVector> u(f.size() - 1);
    u.back() = v;
    for (std::size_t t = u.size() - 1; t > 0; --t) u[t - 1] = horner(block, u[t], f[t], v);
    return u;
}

Number to_number(const NumberField& field, Polynomial value) {
    divide(value, field.minimal_polynomial());
    return Number(field, std::vector<Rational>(value.begin(), value.end()));
}

/// b = Σ_j ρ^j planes[j] / denominator.
struct Planes {
    std::vector<IntegerVector> planes;
    Integer denominator = 1;
};

Planes split(const std::vector<Number>& b, const NumberField& field) {
    std::vector<std::vector<Rational>> coefficients;
    Planes result;
    for (const Number& entry : b) {
        coefficients.push_back(entry.coefficients(field));
        for (const Rational& c : coefficients.back()) result.denominator = lcm(result.denominator, c.get_den());
    }
    result.planes.assign(field.degree(), IntegerVector(b.size()));
    for (std::size_t i = 0; i < b.size(); ++i)
        for (std::size_t j = 0; j < field.degree(); ++j)
            result.planes[j][i] = Rational(coefficients[i][j] * result.denominator).get_num();
    return result;
}

/// Per row the polynomial in ρ of adj(ρI − M) denominator b.
std::vector<Polynomial> adjugate_times(const SparseMatrix& block, const Polynomial& chi, const Planes& b) {
    std::vector<Polynomial> rows(block.size(), Polynomial(chi.size() - 1 + b.planes.size()));
    for (std::size_t j = 0; j < b.planes.size(); ++j) {
        if (std::ranges::all_of(b.planes[j], [](const Integer& entry) { return entry == 0; })) continue;
        const std::vector<IntegerVector> u = difference_quotient(chi, block, b.planes[j]);
        for (std::size_t t = 0; t < u.size(); ++t)
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i][t + j] += u[t][i];
    }
    return rows;
}

} // namespace

std::vector<Number> perron_vector(const SparseMatrix& block, const NumberField& field) {
    if (block.size() == 1) return {Number(1)};
    const Polynomial& p = field.minimal_polynomial();
    Polynomial chi = characteristic_polynomial(block);
    const Polynomial h = divide(chi, p);
    assert(std::ranges::all_of(chi, [](const Integer& entry) { return entry == 0; }) && "the ratio is an eigenvalue");
    const IntegerVector start = apply(h, block, IntegerVector(block.size(), 1));
    const std::vector<IntegerVector> u = difference_quotient(p, block, start);
    std::vector<Number> result;
    for (std::size_t i = 0; i < block.size(); ++i) {
        std::vector<Rational> coefficients;
        for (const IntegerVector& plane : u) coefficients.emplace_back(plane[i]);
        result.emplace_back(field, coefficients);
    }
    return result;
}

std::vector<Number> resolvent(const SparseMatrix& block, const NumberField& field, const std::vector<Number>& b) {
    assert(b.size() == block.size());
    if (block.size() == 1) {
        const Number own(block.front().empty() ? 0L : static_cast<long>(block.front().front().second));
        return {b.front() / (field.generator() - own)};
    }
    const Polynomial chi = characteristic_polynomial(block);
    const Planes planes = split(b, field);
    const Number scale = Number(1) / (to_number(field, chi) * Number(Rational(planes.denominator)));
    std::vector<Number> result;
    for (Polynomial& row : adjugate_times(block, chi, planes))
        result.push_back(to_number(field, std::move(row)) * scale);
    return result;
}

} // namespace internode
