// SPDX-License-Identifier: MIT
//
// Exact: the factor of the characteristic polynomial with the largest real root, roots told apart by refining. Bounds:
// power iteration in doubles, whose vector is then taken as exact; only the last quotients are rounded, outwards.

#include "internode/algebra/perron.h"

#include "internode/algebra/fraction.h"
#include "internode/algebra/polynomial.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

constexpr int first_bits = 64;

/// The iteration stops after this many multiplications of an entry: below a second on any machine.
constexpr std::size_t work_limit = 20'000'000;

/// Vectors stay below this, so that no product with a 32-bit entry and no sum of 2^32 of them overflows.
constexpr double largest_ratio = 1e280;

std::size_t degree(const Polynomial& polynomial) {
    return polynomial.size() - 1;
}

struct RealRoot {
    std::size_t factor;
    RootBox box;
};

/// The largest real root of each factor that has one.
std::vector<RealRoot> largest_real_roots(const std::vector<std::pair<Polynomial, std::size_t>>& factors, int bits) {
    std::vector<RealRoot> result;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::vector<RootBox> boxes = roots(factors[i].first, bits);
        const auto end = std::ranges::find_if(boxes, [](const RootBox& box) { return !box.real; });
        if (end != boxes.begin()) result.push_back({i, *(end - 1)});
    }
    return result;
}

/// Distinct irreducible factors have distinct roots: refining tells them apart.
RealRoot largest_real_root(const std::vector<std::pair<Polynomial, std::size_t>>& factors) {
    for (int bits = first_bits;; bits *= 2) {
        const std::vector<RealRoot> candidates = largest_real_roots(factors, bits);
        assert(!candidates.empty());
        const auto largest = std::ranges::find_if(candidates, [&](const RealRoot& one) {
            return std::ranges::all_of(candidates, [&](const RealRoot& other) {
                return other.factor == one.factor || other.box.upper < one.box.lower;
            });
        });
        if (largest != candidates.end()) return *largest;
    }
}

/// Whether all conjugates of the largest real root lie strictly inside the unit circle. An irreducible polynomial with
/// a root on the circle is reciprocal; a reciprocal one has 1/z beside z, so only ρ and 1/ρ can pass. Otherwise no
/// root is on the circle and refining decides.
bool is_pisot(const Polynomial& minimal, const RootBox& root) {
    if (degree(minimal) == 1) return root.lower > 1;
    if (std::ranges::equal(minimal, Polynomial(minimal.rbegin(), minimal.rend()))) return degree(minimal) == 2;
    for (int bits = first_bits;; bits *= 2) {
        std::vector<RootBox> boxes = roots(minimal, bits);
        const auto complex = std::ranges::find_if(boxes, [](const RootBox& box) { return !box.real; });
        boxes.erase(complex - 1);
        if (std::ranges::any_of(boxes, [](const RootBox& box) { return box.modulus_lower > 1; })) return false;
        if (std::ranges::all_of(boxes, [](const RootBox& box) { return box.modulus_upper < 1; })) return true;
    }
}

Polynomial cofactor(const std::vector<std::pair<Polynomial, std::size_t>>& factors, std::size_t without) {
    Polynomial product{1};
    for (std::size_t i = 0; i < factors.size(); ++i)
        for (std::size_t power = 0; i != without && power < factors[i].second; ++power)
            product = multiply(product, factors[i].first);
    return product;
}

std::size_t entries(const SparseMatrix& matrix) {
    std::size_t count = 0;
    for (const SparseRow& row : matrix) count += row.size();
    return count;
}

/// Rayleigh-like quotients (Mx)_i / x_i in double: good enough to decide when to stop.
struct Quotients {
    std::vector<double> product; ///< Mx
    double least = 0;
    double largest = 0;
};

Quotients quotients(const SparseMatrix& matrix, const std::vector<double>& x) {
    Quotients result;
    result.product.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        double sum = 0;
        for (const auto& [column, entry] : matrix[i]) sum += entry * x[column];
        result.product[i] = sum;
        const double quotient = sum / x[i];
        result.least = i == 0 ? quotient : std::min(result.least, quotient);
        result.largest = i == 0 ? quotient : std::max(result.largest, quotient);
    }
    return result;
}

/// (M + I)x scaled to min 1: the shift leaves the eigenvectors and stops an imprimitive matrix from oscillating.
std::vector<double> shifted_step(const std::vector<double>& x, const std::vector<double>& product) {
    std::vector<double> next(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) next[i] = product[i] + x[i];
    const double least = *std::ranges::min_element(next);
    for (double& value : next) value /= least;
    return next;
}

std::vector<double> iterate(const SparseMatrix& matrix, double width) {
    std::vector<double> x(matrix.size(), 1.0);
    const std::size_t steps = work_limit / (entries(matrix) + matrix.size());
    for (std::size_t step = 0; step < steps; ++step) {
        const Quotients now = quotients(matrix, x);
        if (now.largest - now.least <= width * now.largest) break;
        std::vector<double> next = shifted_step(x, now.product);
        if (next == x || *std::ranges::max_element(next) > largest_ratio) break;
        x = std::move(next);
    }
    return x;
}

/// x_i is at least 1, hence a multiple of 2^-52: the quotients are exact rationals, rounded once and outwards.
Enclosure certify(const SparseMatrix& matrix, const std::vector<double>& x) {
    assert(!matrix.empty() && x.size() == matrix.size());
    std::vector<Integer> scaled;
    for (const double value : x) scaled.emplace_back(std::ldexp(value, 52));
    Rational least;
    Rational largest;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Integer sum;
        for (const auto& [column, entry] : matrix[i]) sum += scaled[column] * entry;
        assert(scaled[i] > 0);
        const Rational quotient = fraction(sum, scaled[i]);
        if (i == 0 || quotient < least) least = quotient;
        if (i == 0 || quotient > largest) largest = quotient;
    }
    assert(least <= largest);
    return {Number(least).enclosure().first, Number(largest).enclosure().second};
}

} // namespace

Polynomial characteristic_polynomial(const SparseMatrix& matrix) {
    std::vector<std::vector<Integer>> dense(matrix.size(), std::vector<Integer>(matrix.size()));
    for (std::size_t row = 0; row < matrix.size(); ++row)
        for (const auto& [column, entry] : matrix[row]) dense[row].at(column) = entry;
    return internode::characteristic_polynomial(dense);
}

std::optional<PerronRoot> perron_root(const SparseMatrix& matrix, std::size_t max_degree) {
    if (matrix.empty()) throw std::invalid_argument("a matrix without rows has no spectral radius");
    const auto factors = factor(characteristic_polynomial(matrix));
    const RealRoot root = largest_real_root(factors);
    const Polynomial& minimal = factors[root.factor].first;
    if (degree(minimal) > max_degree) return std::nullopt;
    return PerronRoot{NumberField(minimal, root.box.lower, root.box.upper), cofactor(factors, root.factor),
                      factors[root.factor].second, is_pisot(minimal, root.box)};
}

CertifiedRadius enclose_radius(const SparseMatrix& matrix, double width) {
    if (matrix.empty()) throw std::invalid_argument("a matrix without rows has no spectral radius");
    for (const SparseRow& row : matrix)
        if (!row.empty() && row.back().first >= matrix.size()) throw std::invalid_argument("the matrix is not square");
    CertifiedRadius result;
    result.vector = iterate(matrix, width);
    result.radius = certify(matrix, result.vector);
    return result;
}

} // namespace internode
