// SPDX-License-Identifier: MIT
//
// Is every point of a grammar an affine combination of points? An expression Σ α_i P_i is one iff Σ α_i = 1
// (Prusinkiewicz et al. 2003, equations 1 to 3); only then does the curve move with its control polygon.
//
// The sum is compared with 1 as an identity in the numbers of the rule and the constants of the grammar, which
// algebra/symbolic.h decides for quotients of polynomials. min, max, floor, abs and sqrt of terms that vary are
// independent variables there. A sum that is 1 with them is 1; one that is not is refuted by an example or left open.

#pragma once

#include "internode/point/point_system.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace internode {

enum class GrammarPart { Axiom, Input, Rule, Interpretation };

enum class InputPart { First, Each, Last };

/// Which argument of which module of a grammar.
struct ArgumentPlace {
    GrammarPart part = GrammarPart::Rule;
    std::uint32_t pass = 0; ///< number of the interpretation pass, from 0
    std::uint32_t rule = 0; ///< index among the rules, or the rules of the pass
    InputPart input = InputPart::Each;
    std::uint32_t module = 0;   ///< number of the module in the successor, the axiom or the input
    std::uint32_t argument = 0; ///< number of the argument in the module
    friend bool operator==(const ArgumentPlace&, const ArgumentPlace&) = default;
};

enum class AffineVerdict {
    Affine,
    AffineForTheseConstants, ///< the sum is 1 for the values of the constants, not for all
    MixesCoordinates,        ///< literal points or coordinates: no combination of points alone, and so meant
    SumIsNotOne,
    NotDecided,
};

struct AffineFinding {
    ArgumentPlace where;
    SourcePlace place; ///< the expression
    AffineVerdict verdict = AffineVerdict::Affine;
    std::string sum;    ///< "5/4", "1 - 2 t"; empty when it is not known or mixes coordinates
    std::string reason; ///< why it is not decided
};

/// One finding for each argument that is a point, in the order axiom, input, rules, interpretations. Rules that read a
/// letter that no word has are left out. Cost: linear in the grammar, with the bounds of
/// expression/symbolic_value.h.
[[nodiscard]] std::vector<AffineFinding> affine_findings(const PointSystem& system);

/// The findings whose sum is not 1, of the arguments that the words of this system can have: those of the input and of
/// the axiom only where words come from there.
[[nodiscard]] std::vector<AffineFinding> wrong_sums(const PointSystem& system);

/// All findings from the parts of a system: values of the constants by definition, and one layout for the derivation
/// and one after each interpretation pass.
[[nodiscard]] std::vector<AffineFinding>
affine_findings(const PointGrammar& grammar, std::span<const KnownNumber> constants, std::span<const Layout> layouts);

/// The argument that stands there. \throw std::out_of_range when none does
[[nodiscard]] const Expression& expression_at(const PointGrammar& grammar, const ArgumentPlace& where);

/// The names of its formals: those of the rule, the formal of the input, none in an axiom.
[[nodiscard]] std::vector<std::string> formals_at(const PointGrammar& grammar, const ArgumentPlace& where);

/// Whether a grammar with such a finding may be valid: the sum is 1 as an identity, or literal points are meant.
[[nodiscard]] bool is_sound(AffineVerdict verdict);

} // namespace internode
