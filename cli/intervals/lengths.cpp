// SPDX-License-Identifier: MIT

#include "cli/intervals/lengths.h"

namespace internode::cli {

std::vector<CurveLength> current_lengths(const Knots& knots) {
    const IntervalSystem& system = knots.system();
    const Number scale = pow(system.ratio(), -knots.step());
    std::vector<CurveLength> lengths;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        if (!system.occurs(to_symbol(i))) continue;
        const Number length = system.lengths()[i] * scale;
        CurveLength& row = lengths.emplace_back();
        row.symbol = system.alphabet().names()[i];
        row.value = length.to_double();
        for (const Rational& coefficient : length.coefficients(system.field()))
            row.exact.push_back(to_string(coefficient));
    }
    return lengths;
}

} // namespace internode::cli
