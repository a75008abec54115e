// SPDX-License-Identifier: MIT
//
// What `internode validate` says about a point grammar as JSON: format "internode-point-validation",
// docs/schema/point-validation.schema.json.

#pragma once

#include "internode/report/generator.h"
#include "internode/report/text/point_validation_text.h"

#include <string>

namespace internode {

/// The whole document. Rules, modules and steps count from 0, lines from 1.
[[nodiscard]] std::string point_validation_json(const PointValidation& validation, const PointGrammar& grammar,
                                                const GrammarSourceText& source, const Generator& generator);

} // namespace internode
