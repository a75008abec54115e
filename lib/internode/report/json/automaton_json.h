// SPDX-License-Identifier: MIT
//
// A stencil automaton as JSON.

#pragma once

#include "internode/report/automaton_export.h"
#include "internode/report/generator.h"

#include <string>

namespace internode {

/// "internode-automaton" version 1 (docs/json.md): states with their windows and children, rows exact and rounded.
[[nodiscard]] std::string automaton_json(const AutomatonExport& automaton, const Generator& generator);

} // namespace internode
