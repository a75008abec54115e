// SPDX-License-Identifier: MIT
//
// The modules of an axiom, an input or a successor, with the expressions of their parameters. Powers are written out,
// their size is checked before.

#pragma once

#include "internode/grammar/points/point_context.h"
#include "internode/grammar/points/point_grammar.h"

#include <span>
#include <vector>

namespace internode {

/// At least one token. After a complaint some modules may lack. Cost: linear in the tokens and the modules.
[[nodiscard]] std::vector<ModuleTemplate> read_templates(std::span<const Token> tokens, NameScope& scope,
                                                         PointContext& context);

} // namespace internode
