// SPDX-License-Identifier: MIT
//
// What the points of a polygon become, where the grammar says it and where it does not.

#pragma once

#include "internode/grammar/points/point_grammar.h"
#include "internode/point/point_settings.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace internode {

/// The input that stands when the grammar gives none, `P(v)`: none where `P` does not have one parameter.
[[nodiscard]] std::optional<PointInput> default_input(const PointGrammar& grammar);

/// The input that turns polygons into words under these settings, given or by default.
[[nodiscard]] std::optional<PointInput> effective_input(const PointGrammar& grammar, PointStart start);

/// What point i of `count` becomes, i < count.
[[nodiscard]] const std::vector<ModuleTemplate>& input_part(const PointInput& input, std::size_t i, std::size_t count);

} // namespace internode
