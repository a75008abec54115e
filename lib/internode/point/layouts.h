// SPDX-License-Identifier: MIT
//
// What the parameters of each letter are, in the words of the derivation and after each interpretation pass.
//
// The least fixed point: the letters of the input and the axiom are known; a rule all of whose letters are known makes
// the letters of its successor known. In an interpretation pass the rules read the layout before it and write the one
// after it, to which letters that may stay as they are belong too.

#pragma once

#include "internode/point/point_system.h"

#include <vector>

namespace internode {

/// The input that stands when the grammar gives none, `P(v)`: none where `P` does not have one parameter.
[[nodiscard]] std::optional<PointInput> default_input(const PointGrammar& grammar);

/// The input that turns polygons into words under these settings, given or by default.
[[nodiscard]] std::optional<PointInput> effective_input(const PointGrammar& grammar, PointStart start);

/// 1 + passes layouts. Cost: linear in the grammar.
[[nodiscard]] std::vector<Layout> infer_layouts(const PointGrammar& grammar, const PointSettings& settings,
                                                std::vector<PointProblem>& problems);

} // namespace internode
