// SPDX-License-Identifier: MIT
//
// Masks are integers over one denominator. Norms of powers bound ϱ from above, spectral radii of products from below; a
// scheme that is shown to be positive has both from one matrix. Each way ends at its own limit of size, and what it
// found by then stands.

#include "internode/mask/joint_radius.h"

#include "internode/algebra/fraction.h"
#include "internode/algebra/polynomial.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

constexpr std::size_t max_coefficients = 8'192;        // of S^k
constexpr std::size_t max_bits = std::size_t{1} << 22; // of all coefficients of S^k together
constexpr std::size_t max_steps = 24;
constexpr std::size_t max_products = 62;       // of matrices: binary words of up to five letters
constexpr std::size_t max_matrix = 12;         // rows, for products
constexpr std::size_t max_centre = 40;         // rows, for the one matrix of a positive scheme
constexpr std::size_t max_spectral_bits = 128; // of a coefficient, for roots of characteristic polynomials
constexpr std::size_t root_bits = 64;          // of a k-th root
constexpr int modulus_bits = 64;               // of the roots of a characteristic polynomial

/// A mask with a common denominator.
struct ScaledMask {
    std::vector<Integer> numerators;
    Integer denominator = 1;
};

ScaledMask scaled(const std::vector<Rational>& coefficients) {
    ScaledMask mask;
    for (const Rational& coefficient : coefficients) mask.denominator = lcm(mask.denominator, coefficient.get_den());
    for (const Rational& coefficient : coefficients)
        mask.numerators.emplace_back(coefficient.get_num() * (mask.denominator / coefficient.get_den()));
    return mask;
}

/// b(z) · c(z^m): the mask of one more step.
ScaledMask one_more_step(const ScaledMask& b, const ScaledMask& c, std::size_t arity) {
    ScaledMask product;
    product.denominator = b.denominator * c.denominator;
    product.numerators.resize((c.numerators.size() - 1) * arity + b.numerators.size());
    for (std::size_t i = 0; i < c.numerators.size(); ++i)
        for (std::size_t k = 0; k < b.numerators.size(); ++k)
            product.numerators[i * arity + k] += b.numerators[k] * c.numerators[i];
    return product;
}

/// The largest Σ|coefficients| of a residue class modulo `period`.
Rational norm(const ScaledMask& mask, std::size_t period) {
    Integer largest = 0;
    for (std::size_t r = 0; r < period && r < mask.numerators.size(); ++r) {
        Integer sum = 0;
        for (std::size_t k = r; k < mask.numerators.size(); k += period) sum += abs(mask.numerators[k]);
        largest = std::max(largest, sum);
    }
    return fraction(largest, mask.denominator);
}

/// The k-th root of a value >= 0, rounded down or up to a multiple of 2^-64; exact when it is one.
Rational root(const Rational& value, std::size_t k, bool up) {
    if (k == 1) return value;
    const Integer scaled_value = (value.get_num() << (root_bits * k)) / value.get_den();
    const bool truncated = scaled_value * value.get_den() != (value.get_num() << (root_bits * k));
    Integer result;
    const bool exact = mpz_root(result.get_mpz_t(), scaled_value.get_mpz_t(), k) != 0;
    if (up && (!exact || truncated)) ++result;
    return fraction(result, Integer(1) << root_bits);
}

/// Norms of S, S², … while the masks stay short.
void bound_by_norms(const ScaledMask& b, std::size_t arity, JointRadius& radius) {
    ScaledMask power = b;
    std::size_t period = arity;
    for (std::size_t k = 1; k <= max_steps; ++k) {
        const Rational size = norm(power, period);
        const Rational bound = root(size, k, true);
        if (radius.steps == 0 || bound < radius.upper) {
            radius.upper = bound;
            radius.steps = k;
            radius.norm = size;
        }
        if (!radius.contracts_after && size < 1) {
            radius.contracts_after = k;
            radius.contraction = size;
        }
        const std::size_t next = power.numerators.size() * arity + b.numerators.size();
        const std::size_t bits = mpz_sizeinbase(power.denominator.get_mpz_t(), 2) + 64;
        if (next > max_coefficients || next * bits > max_bits) return;
        power = one_more_step(b, power, arity);
        period *= arity;
    }
}

/// Whether the coefficients are short enough for characteristic polynomials and their roots.
bool has_short_coefficients(const ScaledMask& b) {
    return mpz_sizeinbase(b.denominator.get_mpz_t(), 2) <= max_spectral_bits &&
           std::ranges::all_of(b.numerators, [](const Integer& coefficient) {
               return mpz_sizeinbase(coefficient.get_mpz_t(), 2) <= max_spectral_bits;
           });
}

using Matrix = std::vector<std::vector<Integer>>;

/// The integer at place i of the mask, 0 outside.
Integer at(const ScaledMask& mask, std::ptrdiff_t i) {
    return i >= 0 && i < static_cast<std::ptrdiff_t>(mask.numerators.size())
               ? mask.numerators[static_cast<std::size_t>(i)]
               : Integer(0);
}

/// Bounds on the largest modulus of an eigenvalue of matrix / denominator.
std::pair<Rational, Rational> spectral_radius(const Matrix& matrix, const Integer& denominator) {
    std::pair<Rational, Rational> bounds{0, 0};
    for (const auto& [irreducible, multiplicity] : factor(characteristic_polynomial(matrix)))
        for (const RootBox& box : roots(irreducible, modulus_bits)) {
            bounds.first = std::max(bounds.first, box.modulus_lower);
            bounds.second = std::max(bounds.second, box.modulus_upper);
        }
    bounds.first /= denominator;
    bounds.second /= denominator;
    return bounds;
}

/// The window of `rows` differences that starts at place r follows from the window of as many that starts at
/// ceil((r - n)/m): a mask of n + 1 coefficients needs n/(m-1) of them.
std::vector<Matrix> window_matrices(const ScaledMask& b, std::size_t arity) {
    const auto n = static_cast<std::ptrdiff_t>(b.numerators.size()) - 1;
    const auto m = static_cast<std::ptrdiff_t>(arity);
    const auto rows = static_cast<std::size_t>(std::max<std::ptrdiff_t>((n + m - 2) / (m - 1), 1));
    std::vector<Matrix> matrices;
    for (std::ptrdiff_t r = 0; r < m; ++r) {
        const std::ptrdiff_t start = -((n - r) / m) + (r > n ? 1 : 0);
        Matrix matrix(rows, std::vector<Integer>(rows));
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j < rows; ++j)
                matrix[i][j] = at(b, r + static_cast<std::ptrdiff_t>(i) - m * (start + static_cast<std::ptrdiff_t>(j)));
        matrices.push_back(std::move(matrix));
    }
    return matrices;
}

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result(a.size(), std::vector<Integer>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a.size(); ++k) {
            if (a[i][k] == 0) continue;
            for (std::size_t j = 0; j < a.size(); ++j) result[i][j] += a[i][k] * b[k][j];
        }
    return result;
}

/// Spectral radii of all products of 1, 2, … matrices.
void bound_by_products(const ScaledMask& b, std::size_t arity, JointRadius& radius) {
    const std::vector<Matrix> matrices = window_matrices(b, arity);
    if (matrices[0].size() > max_matrix) return;
    std::vector<Matrix> products = matrices;
    Integer denominator = b.denominator;
    std::size_t looked_at = 0;
    for (std::size_t k = 1; looked_at + products.size() <= max_products; ++k) {
        for (const Matrix& matrix : products)
            radius.lower = std::max(radius.lower, root(spectral_radius(matrix, denominator).first, k, false));
        looked_at += products.size();
        if (looked_at + products.size() * arity > max_products) return;
        std::vector<Matrix> longer;
        for (const Matrix& matrix : products)
            for (const Matrix& factor : matrices) longer.push_back(product(matrix, factor));
        products = std::move(longer);
        denominator *= b.denominator;
    }
}

/// Σ_j b_{c+j} z^j on the unit circle as a polynomial in x = z + 1/z, times the denominator.
Polynomial cosine_polynomial(const ScaledMask& b) {
    const std::size_t centre = b.numerators.size() / 2;
    Polynomial sum(centre + 1);
    Polynomial before{Integer(2)}; // z^j + z^-j for j = 0, then 1
    Polynomial now{Integer(0), Integer(1)};
    sum[0] = b.numerators[centre];
    for (std::size_t j = 1; j <= centre; ++j) {
        for (std::size_t i = 0; i < now.size(); ++i) sum[i] += b.numerators[centre + j] * now[i];
        Polynomial next(now.size() + 1);
        for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] += now[i];
        for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
        before = std::move(now);
        now = std::move(next);
    }
    return sum;
}

/// Whether Σ b_k e^{ikω} is e^{icω} times something >= 0 for every ω: provable, or false.
bool is_positive(const ScaledMask& b) {
    if (b.numerators.size() % 2 == 0) return false;
    if (!std::equal(b.numerators.begin(), b.numerators.end(), b.numerators.rbegin())) return false;
    Integer sum = 0; // the value at x = 2, where the sign is that of b(1)
    for (const Integer& coefficient : b.numerators) sum += coefficient;
    if (sum <= 0) return false;
    for (const auto& [irreducible, multiplicity] : factor(cosine_polynomial(b))) {
        if (multiplicity % 2 == 0) continue;
        for (const RootBox& box : roots(irreducible, modulus_bits))
            if (box.real && box.upper > -2 && box.lower < 2) return false;
    }
    return true;
}

/// The exact radius of a positive scheme, when its matrix is not too large.
void bound_by_centre(const ScaledMask& b, std::size_t arity, JointRadius& radius) {
    const auto half = static_cast<std::ptrdiff_t>(b.numerators.size() / 2);
    const auto m = static_cast<std::ptrdiff_t>(arity);
    const std::ptrdiff_t reach = (half + m - 2) / (m - 1);
    const auto rows = static_cast<std::size_t>(2 * reach + 1);
    if (rows > max_centre || !is_positive(b)) return;
    Matrix matrix(rows, std::vector<Integer>(rows));
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < rows; ++i)
            matrix[j][i] =
                at(b, half + (static_cast<std::ptrdiff_t>(j) - reach) - m * (static_cast<std::ptrdiff_t>(i) - reach));
    const auto [lower, upper] = spectral_radius(matrix, b.denominator);
    radius.positive = true;
    radius.lower = std::max(radius.lower, lower);
    radius.upper = std::min(radius.upper, upper);
}

} // namespace

JointRadius joint_radius(const std::vector<Rational>& coefficients, std::size_t arity, RadiusBounds bounds) {
    assert(arity >= 2 && !coefficients.empty());
    const ScaledMask b = scaled(coefficients);
    JointRadius radius;
    bound_by_norms(b, arity, radius);
    if (bounds == RadiusBounds::Norms || !has_short_coefficients(b)) return radius;
    bound_by_products(b, arity, radius);
    bound_by_centre(b, arity, radius);
    return radius;
}

} // namespace internode
