// SPDX-License-Identifier: MIT
//
// Validity by definition (Nivoliers et al. 2012, Definition 3.1) for matrices of up to three rows: is there a real
// eigenvalue above 1 with an eigenvector of positive entries? Characteristic polynomial by cofactors, eigenvalues by
// trial (integers) and by Sturm sequences (quadratic and cubic irrationals), eigenvectors by Fourier–Motzkin
// elimination and by the adjugate. No graph, no classes, no spectral radius, no number field.
//
// And for more rows in floating point: the quotients (Mx)_i / x_i of the iterated vector agree in the limit iff a
// positive eigenvector exists; how far apart they still are tells a margin.

#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace internode::reference {

using Matrix = std::vector<std::vector<int>>;
using Fraction = mpq_class;
using Fractions = std::vector<Fraction>; ///< a polynomial, low degree first, or a row

inline Fractions add(const Fractions& a, const Fractions& b, int sign = 1) {
    Fractions sum(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
    for (std::size_t i = 0; i < b.size(); ++i) sum[i] += sign * b[i];
    while (!sum.empty() && sum.back() == 0) sum.pop_back();
    return sum;
}

inline Fractions times(const Fractions& a, const Fractions& b) {
    if (a.empty() || b.empty()) return {};
    Fractions product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    return product;
}

inline Fractions remainder(Fractions a, const Fractions& b) {
    while (a.size() >= b.size()) {
        const Fraction factor = a.back() / b.back();
        for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
        a.pop_back();
        while (!a.empty() && a.back() == 0) a.pop_back();
    }
    return a;
}

inline Fraction value(const Fractions& polynomial, const Fraction& x) {
    Fraction sum;
    for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * x + polynomial[i];
    return sum;
}

using PolynomialMatrix = std::vector<std::vector<Fractions>>;

/// By expansion along the first row.
inline Fractions determinant(const PolynomialMatrix& matrix) {
    if (matrix.empty()) return {1};
    Fractions sum;
    for (std::size_t j = 0; j < matrix.size(); ++j) {
        PolynomialMatrix minor;
        for (std::size_t i = 1; i < matrix.size(); ++i) {
            minor.push_back(matrix[i]);
            minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
        }
        sum = add(sum, times(matrix[0][j], determinant(minor)), j % 2 == 0 ? 1 : -1);
    }
    return sum;
}

/// xI − M.
inline PolynomialMatrix pencil(const Matrix& matrix) {
    PolynomialMatrix result(matrix.size(), std::vector<Fractions>(matrix.size()));
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix.size(); ++j)
            result[i][j] = add(i == j ? Fractions{0, 1} : Fractions{}, Fractions{Fraction(matrix[i][j])}, -1);
    return result;
}

/// The number of real roots in (lower, upper] of a squarefree polynomial.
inline int sturm_count(const Fractions& polynomial, const Fraction& lower, const Fraction& upper) {
    std::vector<Fractions> chain{polynomial, {}};
    for (std::size_t i = 1; i < polynomial.size(); ++i) chain[1].push_back(polynomial[i] * static_cast<int>(i));
    while (chain.back().size() > 1) {
        Fractions next = remainder(chain[chain.size() - 2], chain.back());
        for (Fraction& coefficient : next) coefficient = -coefficient;
        chain.push_back(std::move(next));
    }
    const auto variations = [&](const Fraction& x) {
        int count = 0;
        int last = 0;
        for (const Fractions& one : chain) {
            const int sign = sgn(value(one, x));
            if (sign != 0 && last != 0 && sign != last) ++count;
            if (sign != 0) last = sign;
        }
        return count;
    };
    return variations(lower) - variations(upper);
}

/// An irrational root: the only one of an irreducible polynomial in (lower, upper].
struct Root {
    Fractions polynomial;
    Fraction lower;
    Fraction upper;

    /// The sign of another polynomial there: exact, since it vanishes only as a multiple.
    int sign_of(const Fractions& other) {
        const Fractions rest = remainder(other, polynomial);
        if (rest.empty()) return 0;
        // rest has lower degree, hence no common root: shrink until it has no root in the interval at all.
        for (;;) {
            const int low = sgn(value(rest, lower));
            const bool constant = rest.size() == 1;
            const bool linear_same = rest.size() == 2 && low == sgn(value(rest, upper));
            if (low != 0 && (constant || linear_same)) return low;
            if (low != 0 && rest.size() == 3 && sturm_free(rest)) return low;
            halve();
        }
    }

private:
    bool sturm_free(const Fractions& quadratic) const {
        const Fraction discriminant = quadratic[1] * quadratic[1] - 4 * quadratic[0] * quadratic[2];
        if (discriminant < 0) return true;
        if (discriminant == 0) {
            const Fraction root = -quadratic[1] / (2 * quadratic[2]);
            return root < lower || root > upper;
        }
        return sturm_count(quadratic, lower, upper) == 0;
    }
    void halve() {
        const Fraction middle = (lower + upper) / 2;
        (sturm_count(polynomial, lower, middle) == 1 ? upper : lower) = middle;
    }
};

/// All roots of an irreducible polynomial in (lower, upper], isolated.
inline void isolate(const Fractions& polynomial, const Fraction& lower, const Fraction& upper,
                    std::vector<Root>& roots) {
    const int count = sturm_count(polynomial, lower, upper);
    if (count == 1) roots.push_back({polynomial, lower, upper});
    if (count < 2) return;
    const Fraction middle = (lower + upper) / 2;
    isolate(polynomial, lower, middle, roots);
    isolate(polynomial, middle, upper, roots);
}

/// Whether rows x >= bounds has a solution, by Fourier–Motzkin: each row is (coefficients…, bound).
inline bool feasible(std::vector<Fractions> rows, std::size_t variables) {
    for (std::size_t v = 0; v < variables; ++v) {
        std::vector<Fractions> next;
        for (const Fractions& row : rows)
            if (row[v] == 0) next.push_back(row);
        for (const Fractions& up : rows) {
            for (const Fractions& down : rows) {
                if (up[v] <= 0 || down[v] >= 0) continue;
                Fractions& sum = next.emplace_back(up.size());
                for (std::size_t i = 0; i < up.size(); ++i) sum[i] = up[i] * -down[v] + down[i] * up[v];
            }
        }
        rows = std::move(next);
    }
    return std::ranges::all_of(rows, [](const Fractions& row) { return row.back() <= 0; });
}

/// Whether (M − λI) x = 0, x >= 1 has a solution.
inline bool has_positive_vector(const Matrix& matrix, int eigenvalue) {
    const std::size_t n = matrix.size();
    std::vector<Fractions> rows;
    for (std::size_t i = 0; i < n; ++i) {
        Fractions row(n + 1);
        for (std::size_t j = 0; j < n; ++j) row[j] = matrix[i][j] - (i == j ? eigenvalue : 0);
        Fractions opposite = row;
        for (Fraction& entry : opposite) entry = -entry;
        Fractions positive(n + 1);
        positive[i] = positive[n] = 1;
        rows.insert(rows.end(), {row, opposite, positive});
    }
    return feasible(rows, n);
}

/// The same for an irrational λ, a simple eigenvalue: the null vector is any column of adj(λI − M) that is not zero.
inline bool has_positive_vector(const Matrix& matrix, Root root) {
    const std::size_t n = matrix.size();
    for (std::size_t column = 0; column < n; ++column) {
        int positive = 0;
        int negative = 0;
        for (std::size_t row = 0; row < n; ++row) {
            PolynomialMatrix minor = pencil(matrix);
            minor.erase(minor.begin() + static_cast<std::ptrdiff_t>(column));
            for (auto& entries : minor) entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(row));
            const int sign = root.sign_of(determinant(minor)) * ((row + column) % 2 == 0 ? 1 : -1);
            positive += sign > 0 ? 1 : 0;
            negative += sign < 0 ? 1 : 0;
        }
        if (positive + negative == 0) continue;
        return positive == static_cast<int>(n) || negative == static_cast<int>(n);
    }
    return false;
}

/// Definition 3.1, exactly, for up to three rows.
inline bool is_valid(const Matrix& matrix) {
    Fractions chi = determinant(pencil(matrix));
    int largest = 1; // no eigenvalue is above the largest row sum
    for (const auto& row : matrix) {
        int sum = 0;
        for (const int entry : row) sum += entry;
        largest = std::max(largest, sum);
    }
    for (int candidate = -largest; candidate <= largest; ++candidate) {
        if (value(chi, candidate) != 0) continue;
        if (candidate > 1 && has_positive_vector(matrix, candidate)) return true;
        while (chi.size() > 1 && value(chi, candidate) == 0) {
            Fractions quotient(chi.size() - 1); // synthetic division by x − candidate
            for (std::size_t i = chi.size() - 1; i > 0; --i)
                quotient[i - 1] = chi[i] + (i < quotient.size() ? Fraction(candidate * quotient[i]) : Fraction(0));
            chi = quotient;
        }
    }
    if (chi.size() < 3) return false; // what is left has no rational root: irreducible of degree 2 or 3
    std::vector<Root> roots;
    isolate(chi, 1, largest, roots);
    return std::ranges::any_of(roots, [&](const Root& root) { return has_positive_vector(matrix, root); });
}

/// A floating answer with its margin: empty when the quotients neither agree nor clearly differ.
inline std::optional<bool> is_valid_in_floating_point(const Matrix& matrix) {
    std::vector<double> x(matrix.size(), 1.0);
    double least = 0;
    double largest = 0;
    for (int step = 0; step < 6000; ++step) {
        std::vector<double> next(x.size());
        least = HUGE_VAL;
        largest = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t j = 0; j < x.size(); ++j) next[i] += matrix[i][j] * x[j];
            least = std::min(least, next[i] / x[i]);
            largest = std::max(largest, next[i] / x[i]);
            next[i] += x[i];
        }
        if (largest - least < 1e-12) break;
        const double scale = *std::ranges::max_element(next);
        for (double& entry : next) entry /= scale;
        if (*std::ranges::min_element(next) < 1e-200) return false;
        x = next;
    }
    if (largest - least < 1e-9) return least > 1 + 1e-6;
    if (largest - least > 1e-5) return false;
    return std::nullopt;
}

} // namespace internode::reference
