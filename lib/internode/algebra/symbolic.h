// SPDX-License-Identifier: MIT
//
// Quotients p/q of polynomials with rational coefficients in named variables: the coefficients of a rule before its
// parameters have values, such as (1 - t) or 1/n.
//
// Identity is decided by cross multiplication, p_1 q_2 = p_2 q_1, so no greatest common divisor is needed; what cancels
// by exact division is cancelled, for short prints. Polynomials stay within `symbolic_limits`: an operation that would
// leave them has no result, and whoever asked says "not decided".

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace internode {

/// Index in the caller's list of names.
using SymbolicVariable = std::uint32_t;

/// x_1^{e_1} x_2^{e_2} …: variables ascending, exponents > 0.
using Monomial = std::vector<std::pair<SymbolicVariable, std::uint32_t>>;

/// Graded lexicographic: by total degree, then the larger power of the first variable is larger.
struct MonomialLess {
    [[nodiscard]] bool operator()(const Monomial& a, const Monomial& b) const;
};

/// Without zero coefficients.
using SymbolicPolynomial = std::map<Monomial, Rational, MonomialLess>;

struct SymbolicLimits {
    std::size_t terms = 500;         ///< terms of a polynomial
    std::size_t products = 20'000;   ///< products of two terms in one multiplication
    std::uint32_t degree = 200;      ///< total
    std::size_t coefficient = 4'096; ///< bits of a numerator or denominator
};
inline constexpr SymbolicLimits symbolic_limits;

class Symbolic {
public:
    /// 0.
    Symbolic() = default;
    explicit Symbolic(const Rational& value);
    [[nodiscard]] static Symbolic variable(SymbolicVariable variable);

    [[nodiscard]] const SymbolicPolynomial& numerator() const { return numerator_; }
    /// Integer coefficients without a common factor, the one of the largest monomial positive.
    [[nodiscard]] const SymbolicPolynomial& denominator() const { return denominator_; }
    [[nodiscard]] bool is_zero() const { return numerator_.empty(); }
    /// Equal to 1 as an identity.
    [[nodiscard]] bool is_one() const { return numerator_ == denominator_; }
    /// The value, when it is written without variables.
    [[nodiscard]] std::optional<Rational> constant() const;
    /// The variables that occur, ascending.
    [[nodiscard]] std::vector<SymbolicVariable> variables() const;
    /// At these values of all variables, in doubles; not finite where the denominator vanishes.
    [[nodiscard]] double evaluate(std::span<const double> values) const;

    [[nodiscard]] Symbolic operator-() const;
    friend std::optional<Symbolic> add(const Symbolic& a, const Symbolic& b);
    friend std::optional<Symbolic> multiply(const Symbolic& a, const Symbolic& b);
    friend std::optional<Symbolic> divide(const Symbolic& a, const Symbolic& b);

private:
    Symbolic(SymbolicPolynomial numerator, SymbolicPolynomial denominator);

    SymbolicPolynomial numerator_;
    SymbolicPolynomial denominator_{{Monomial{}, Rational(1)}};
};

/// Sum, product and quotient; none beyond the limits.
[[nodiscard]] std::optional<Symbolic> add(const Symbolic& a, const Symbolic& b);
[[nodiscard]] std::optional<Symbolic> multiply(const Symbolic& a, const Symbolic& b);
/// \throw std::domain_error when b is zero
[[nodiscard]] std::optional<Symbolic> divide(const Symbolic& a, const Symbolic& b);

/// Whether a = b as an identity in the variables; none when the products are beyond the limits.
[[nodiscard]] std::optional<bool> identical(const Symbolic& a, const Symbolic& b);

/// "5/4", "1 - 2 t", "(n - 1)/(2 n)": low degrees first, names as given, ASCII when they are.
[[nodiscard]] std::string to_string(const Symbolic& value, std::span<const std::string> names);

} // namespace internode
