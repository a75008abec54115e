// SPDX-License-Identifier: MIT
//
// Marsden's identity: the control points of t^m over knots t_1 … t_d each are the blossom of t^m there, the elementary
// symmetric polynomial e_m(t_1, …, t_d) divided by its number of terms.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace internode::reference {

/// The blossom of t^m, as a polynomial of degree d = arguments.size() >= m, by adding an argument at a time.
template<typename Field>
Field polar_power(std::span<const Field> arguments, std::size_t m) {
    std::vector<Field> symmetric(m + 1, Field(0));
    std::vector<Field> terms(m + 1, Field(0)); // the same with every argument 1
    symmetric[0] = terms[0] = Field(1);
    for (const Field& argument : arguments) {
        for (std::size_t i = m; i >= 1; --i) {
            symmetric[i] += symmetric[i - 1] * argument;
            terms[i] += terms[i - 1];
        }
    }
    return symmetric[m] / terms[m];
}

} // namespace internode::reference
