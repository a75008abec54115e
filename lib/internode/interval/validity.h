// SPDX-License-Identifier: MIT
//
// The decision whether a grammar is a valid interval subdivision descriptor (Nivoliers et al. 2012, Definition 3.1).
//
// M = [m_ij] has arcs i -> j where m_ij > 0, and strongly connected classes. A class is *final* when no arc leaves it,
// *basic* when its block has spectral radius ρ = ρ(M). A strictly positive a with M a = ρ a exists iff the final
// classes are exactly the basic ones (Berman and Plemmons, Nonnegative Matrices, ch. 2; Rothblum 1975). The system is
// valid iff, besides, ρ > 1. Lengths are unique up to one positive scale per final class. Symbols that the axiom can
// never produce, and the letter `0`, are left out. Decided exactly, or by enclosures that separate, or not at all:
// never by a tolerance.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/interval/interval_system.h"
#include "internode/interval/quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

enum class Decision { Valid, Invalid, Undecided };

enum class ReasonCode {
    NeverSplits,     ///< a final class of ratio 1 in a system of larger ratio
    FinalTooSmall,   ///< a final class whose ratio, above 1, is below the system's
    FinalDisagree,   ///< two final classes of different ratio
    BasicNotFinal,   ///< a class of the largest ratio that still produces other classes
    RatioOne,        ///< ρ = 1: lengths cannot shrink
    LengthsDisagree, ///< declared lengths that do not satisfy ρ a = M a
    Overlap,         ///< two enclosures that could not be separated
};
/// "never-splits", … as JSON says it.
[[nodiscard]] std::string_view to_string(ReasonCode code);

struct Reason {
    ReasonCode code{};
    std::vector<Symbol> symbols; ///< the classes meant
    std::string message;         ///< a full sentence with names and numbers
};

struct SymbolClass {
    std::vector<Symbol> symbols; ///< ascending
    bool final = false;
    std::optional<bool> basic; ///< empty when undecided
    std::size_t period = 0;    ///< 1 = primitive; 0 = no cycle (a symbol that only passes by)
    Quantity ratio;            ///< the spectral radius of the class's own block, in a field of its own
};

struct Verdict {
    Decision decision = Decision::Undecided;
    std::vector<Reason> reasons;          ///< why not; empty when valid
    std::vector<std::string> theorems;    ///< "3.7", "3.8" (S4) or "criterion"; empty unless valid
    bool exact = false;                   ///< ratio known in the field, and lengths if valid
    std::optional<NumberField> field;     ///< Q(ρ) when exact
    Quantity ratio;                       ///< ρ(M)
    std::optional<bool> pisot;            ///< whether the ratio is a Pisot number, when exact
    std::size_t period = 0;               ///< lcm over basic classes
    std::vector<bool> occurs;             ///< whether the axiom can produce each symbol
    std::vector<SymbolClass> classes;     ///< all classes in order of their first symbol
    std::size_t free_lengths = 0;         ///< number of final classes
    std::vector<Quantity> lengths;        ///< n, or empty when there are none
    std::vector<Quantity> frequencies;    ///< n, or empty when they depend on an axiom that is not given
    std::optional<IntervalSystem> system; ///< valid and exact
};

struct ValidityLimits {
    std::size_t exact_class = 200; ///< the largest class whose characteristic polynomial is computed
    std::size_t field_degree = 32; ///< the largest degree of an exact field
};

/// Decides. Lengths are scaled per final class so that the shortest symbol that leads to it and to no other is 1,
/// unless the grammar declares lengths. Beyond the limits a valid system has no IntervalSystem; its lengths and
/// frequencies are bounds if it has one final class and the iterations come close enough, else empty. Cost: exact up to
/// 64 symbols and degree 32 in well under 2 s; 10,000 sparse symbols in under 1 s.
[[nodiscard]] Verdict validate(const IntervalGrammar& grammar, const ValidityLimits& limits = {});

} // namespace internode
