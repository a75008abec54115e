// SPDX-License-Identifier: MIT
//
// The only door to IntervalSystem: for validate() and for functions that keep ρ a = M a true. Not installed.

#pragma once

#include "internode/interval/interval_system.h"

namespace internode {

struct SystemMaker {
    /// "φ" for the golden ratio, else "ρ".
    [[nodiscard]] static std::string generator_name(const NumberField& field);
    [[nodiscard]] static IntervalSystem make(IntervalGrammar grammar, NumberField field, Number ratio,
                                             std::vector<Number> lengths, std::size_t period);
};

} // namespace internode
