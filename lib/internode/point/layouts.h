// SPDX-License-Identifier: MIT
//
// What the parameters of each letter are, in the words of the derivation and after each interpretation pass.
//
// The least fixed point: the letters of the input and the axiom are known; a rule all of whose letters are known makes
// the letters of its successor known. In an interpretation pass the rules read the layout before it and write the one
// after it, to which letters that may stay as they are belong too.

#pragma once

#include "internode/grammar/points/point_grammar.h"
#include "internode/point/layout.h"
#include "internode/point/point_settings.h"

#include <vector>

namespace internode {

/// 1 + passes layouts. Cost: linear in the grammar.
[[nodiscard]] std::vector<Layout> infer_layouts(const PointGrammar& grammar, const PointSettings& settings,
                                                std::vector<PointProblem>& problems);

} // namespace internode
