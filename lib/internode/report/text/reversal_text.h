// SPDX-License-Identifier: MIT
//
// The reversal of a polygon by a point grammar, for a terminal.

#pragma once

#include "internode/report/reversal_report.h"

#include <string>

namespace internode {

/// The production of a derived rule, as the language writes it.
[[nodiscard]] std::string production_text(const ReverseRule& rule);

/// A heading, the rule with its gain, a table of the levels.
[[nodiscard]] std::string reversal_text(const ReversalReport& report);

} // namespace internode
