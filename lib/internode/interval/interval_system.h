// SPDX-License-Identifier: MIT
//
// A valid interval system: a grammar, its ratio ρ > 1 and lengths a > 0 with ρ a = M a, all exact in K = Q(ρ)
// (Nivoliers et al. 2012, Definition 3.1 and eq. 4). After s steps an interval A_i has length a_i / ρ^s.
//
// Only validate() (interval/validity.h) and the functions below make one, so whoever holds one need not check again.
// An immutable value; copies are cheap. Numbers of one system belong to one thread at a time (algebra/number.h).

#pragma once

#include "internode/algebra/number.h"
#include "internode/grammar/intervals/interval_grammar.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace internode {

class IntervalSystem {
public:
    [[nodiscard]] const IntervalGrammar& grammar() const { return impl_->grammar; }
    [[nodiscard]] const Alphabet& alphabet() const { return impl_->grammar.alphabet; }
    [[nodiscard]] const Morphism& rules() const { return impl_->grammar.rules; }
    [[nodiscard]] const NumberField& field() const { return impl_->field; }
    [[nodiscard]] const Number& ratio() const { return impl_->ratio; }
    /// The name of ρ in print: "φ" for the golden ratio, else "ρ".
    [[nodiscard]] const std::string& ratio_name() const { return impl_->ratio_name; }
    /// a_i of each symbol; 0 exactly for symbols that the axiom can never produce.
    [[nodiscard]] const std::vector<Number>& lengths() const { return impl_->lengths; }
    /// a_i, or 0 for the reserved letter `0`.
    [[nodiscard]] const Number& length(Symbol symbol) const;
    /// Whether the symbol has a length: false for what the axiom can never produce.
    [[nodiscard]] bool occurs(Symbol symbol) const;
    /// The period of the system: the least common multiple of the periods of its basic classes (1 = primitive blocks).
    [[nodiscard]] std::size_t period() const { return impl_->period; }

private:
    struct Impl {
        IntervalGrammar grammar;
        NumberField field;
        Number ratio;
        std::string ratio_name;
        std::vector<Number> lengths;
        std::size_t period = 1;
    };
    explicit IntervalSystem(Impl impl)
        : impl_(std::make_shared<const Impl>(std::move(impl))) {}
    friend struct SystemMaker;
    std::shared_ptr<const Impl> impl_;
};

/// Uniform bisection of the same intervals: same alphabet and lengths, every rule A_i -> A_i A_i, ratio 2
/// (Sederberg's scheme, S4 3.3.2; every length is free, so lengths in K are allowed).
[[nodiscard]] IntervalSystem bisection(const IntervalSystem& system);

/// What the rules of a power may hold together: 2^24 letters.
inline constexpr std::uint64_t max_power_letters = std::uint64_t{1} << 24;

/// `steps` steps at once: the rules σ^steps over the same lengths and in the same field, ratio ρ^steps (M a = ρ a gives
/// M^k a = ρ^k a). Its automaton is the composition of `steps` automata, exactly: a row is determined by its window and
/// child, so products of rows could give nothing else (docs/mathematics.md). A name gets `^steps`.
/// \throw std::invalid_argument for fewer than one step, std::length_error beyond max_power_letters
[[nodiscard]] IntervalSystem power(const IntervalSystem& system, int steps);

/// The rule of a one-symbol grammar, A -> A…A of k letters, for intervals of many lengths: symbol i has names[i] and
/// lengths[i], and splits into k of itself. Each is a final class, so every length is free (S4 3.3.2). The grammar
/// declares the lengths; an axiom does not survive. \throw std::invalid_argument unless the grammar has one symbol, and
/// for no names, a name twice, as many lengths as names, a length that is not positive
[[nodiscard]] IntervalSystem one_symbol_a_length(const IntervalSystem& system, const std::vector<std::string>& names,
                                                 const std::vector<Rational>& lengths);

/// A length said from outside, > 0: rational, or in K (a refined curve's lengths are a_i / ρ^s).
struct FixedLength {
    Symbol symbol{};
    Number length;
};

/// Lengths fixed from outside did not satisfy ρ a = M a.
struct LengthConflict {
    Symbol symbol{};
    Number given;        ///< what was asked for
    Number implied;      ///< what the system says, after the other lengths were taken
    std::string message; ///< a sentence with both numbers and the residual
};

struct FixedLengths {
    std::optional<IntervalSystem> system; ///< none when there are conflicts
    std::vector<LengthConflict> conflicts;
};

/// The same system with some lengths given: each scales the final class that its symbol leads to; the others follow.
/// Every given length must then hold exactly. \throw std::invalid_argument for a power of several steps where a symbol
/// leads to several final classes: give the lengths before it is taken
[[nodiscard]] FixedLengths with_lengths(const IntervalSystem& system, const std::vector<FixedLength>& lengths);

} // namespace internode
