// SPDX-License-Identifier: MIT
//
// The verdict on a grammar as JSON: format "internode-validation", docs/schema/validation.schema.json.

#pragma once

#include "internode/interval/validity.h"
#include "internode/report/generator.h"

#include <string>

namespace internode {

/// The whole document. Lengths and frequencies that are not known are null.
[[nodiscard]] std::string validation_json(const Verdict& verdict, const IntervalGrammar& grammar,
                                          const Generator& generator);

} // namespace internode
