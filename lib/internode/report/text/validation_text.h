// SPDX-License-Identifier: MIT
//
// The verdict on a grammar for a person at a terminal.

#pragma once

#include "internode/interval/validity.h"

#include <string>

namespace internode {

[[nodiscard]] std::string validation_text(const Verdict& verdict, const IntervalGrammar& grammar);

/// "φ" for the golden ratio, else "ρ": the name of the ratio in print.
[[nodiscard]] std::string ratio_name(const Verdict& verdict);

} // namespace internode
