// SPDX-License-Identifier: MIT
//
// Which symbols of a system have the lengths of given intervals: at which scale of its lengths, and by what names.
//
// Lengths are unique up to one scale per final class. A class whose scale nobody said takes the one at which all
// intervals fit, if there is exactly one such scale and exactly one such class. Not installed.

#pragma once

#include "internode/interval/interval_system.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace internode {

/// "3/2", "2φ−3 ≈ 0.2361"; a rounded number where the exact one is long.
[[nodiscard]] std::string exact_text(const Number& number, const IntervalSystem& system);

struct ScaledSystem {
    std::optional<IntervalSystem> system;
    std::string problem; ///< why there is none
};

/// The system at the scale that the intervals say; lengths 0 are passed over. A scale is settled by the grammar's
/// declarations and by `fixed`. Symbols that lead to several final classes say nothing about an open scale.
[[nodiscard]] ScaledSystem fit_scale(const IntervalSystem& system, const std::vector<Number>& intervals,
                                     const std::vector<Symbol>& fixed);

/// The symbols of a system by their lengths.
class LengthTable {
public:
    explicit LengthTable(const IntervalSystem& system);
    /// Those of that length; the reserved letter for 0.
    [[nodiscard]] const std::vector<Symbol>& symbols(const Number& length) const;
    /// Why the length does not name one symbol.
    [[nodiscard]] std::string complaint(const Number& length) const;

private:
    IntervalSystem system_;
    std::map<Number, std::vector<Symbol>> symbols_;
};

} // namespace internode
