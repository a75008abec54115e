// SPDX-License-Identifier: MIT
//
// Why a system is not valid, or cannot be decided, in sentences a person can read. Every reason there is, by class in
// order of first symbols. Not installed.

#pragma once

#include "internode/interval/class_radius.h"
#include "internode/interval/validity.h"

namespace internode {

struct Diagnosis {
    const Alphabet& names;
    const ClassGraph& graph;
    const std::vector<ClassRadius>& radii;
    const LargestRadius& largest;
};

/// Facts that make the system invalid: final classes that are not basic, basic ones that are not final, ρ = 1. Empty
/// exactly when the system is valid, provided that nothing is unordered.
[[nodiscard]] std::vector<Reason> refutations(const Diagnosis& diagnosis);

/// The pairs of classes whose ratios could not be told apart.
[[nodiscard]] std::vector<Reason> overlaps(const Diagnosis& diagnosis);

} // namespace internode
