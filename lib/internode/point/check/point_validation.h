// SPDX-License-Identifier: MIT
//
// Everything that `internode validate` says about a point grammar, as one value: the text and the JSON print the same.
//
// A grammar is valid iff its parameters have kinds, every point expression is affine or meant to be something else
// (literal points, coordinates), and the ends of open words are complete. What compiles, how smooth it is and what it
// is called are facts beside that.

#pragma once

#include "internode/mask/known_schemes.h"
#include "internode/mask/mask_properties.h"
#include "internode/mask/smoothness.h"
#include "internode/mask/uniform_mask.h"
#include "internode/point/check/affine.h"
#include "internode/point/check/coverage.h"
#include "internode/point/compile/compile.h"
#include "internode/point/compile/interval_twin.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace internode {

/// What the compiler says (point/compile/compile.h) of polygons of many points, or of the axiom.
struct CompilationFacts {
    bool compiles = false;
    std::vector<ExactStop> reasons;   ///< why not
    std::size_t states = 0;           ///< states of the automaton
    std::optional<UniformMask> mask;  ///< the mask of one cycle, when it is the same everywhere but at ends
    std::optional<IntervalTwin> twin; ///< the interval grammar with the same automaton
};

/// What follows from the mask.
struct MaskFacts {
    UniformMask mask;
    MaskProperties properties;
    std::vector<KnownScheme> known;
    std::optional<Smoothness> smoothness; ///< none for long masks
};

struct PointValidation {
    bool valid = false;
    std::size_t dimension = 2;          ///< coordinates of the points of the input
    std::vector<PointProblem> problems; ///< why the grammar cannot be run; then the rest is empty
    std::vector<AffineFinding> affine;
    std::optional<Coverage> coverage;
    std::optional<CompilationFacts> compilation;
    std::optional<MaskFacts> mask; ///< none when there is none, or one too long to look at
};

/// Longer masks are not looked at: their analysis is quadratic.
inline constexpr std::size_t max_validated_coefficients = 512;

/// \throw std::invalid_argument for a mask of arity below 2 or without coefficients
[[nodiscard]] MaskFacts mask_facts(const UniformMask& mask);

/// Cost: bounded by the limits of its parts; a few milliseconds for the grammars of the papers.
[[nodiscard]] PointValidation make_point_validation(const PointSystem& system);

/// Of a grammar: as a system of points of two coordinates, or three or four when its rules ask for so many; the
/// problems of two when it is a system of none. `settings.dimension` is not looked at.
[[nodiscard]] PointValidation make_point_validation(const PointGrammar& grammar, PointSettings settings = {});

} // namespace internode
