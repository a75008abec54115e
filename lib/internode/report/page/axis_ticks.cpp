// SPDX-License-Identifier: MIT
//
// A linear axis takes the largest step of 1, 2 or 5 times a power of ten that gives four steps or more. A logarithmic
// one takes powers of ten, each n-th where there are many, and 2 and 5 times them where there are few.

#include "internode/report/page/axis_ticks.h"

#include "internode/algebra/logarithm.h"
#include "internode/report/picture/svg.h"
#include "internode/report/text/text_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace internode {

namespace {

constexpr int most_decades = 8;

/// 10^exponent by multiplication: pow() differs between machines.
double power_of_ten(int exponent) {
    double value = 1;
    for (int i = 0; i < std::abs(exponent); ++i) value *= 10;
    return exponent < 0 ? 1 / value : value;
}

/// factor 10^exponent: plain where that is short, "10⁻⁶" and "2·10⁻⁶" elsewhere.
std::string power_label(int factor, int exponent) {
    if (exponent >= 0 && exponent <= 5)
        return std::to_string(factor) + std::string(static_cast<std::size_t>(exponent), '0');
    if (exponent < 0 && exponent >= -3)
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + std::to_string(factor);
    const std::string power = "10" + superscript(exponent);
    return factor == 1 ? power : std::to_string(factor) + "·" + power;
}

std::vector<Tick> logarithmic_ticks(double least, double greatest) {
    const int first = static_cast<int>(std::floor(least));
    const int last = static_cast<int>(std::floor(greatest));
    const int stride = 1 + (last - first) / most_decades;
    const bool are_few = last - first <= 2;
    std::vector<Tick> ticks;
    for (int exponent = first; exponent <= last; exponent += stride) {
        for (const int factor : {1, 2, 5}) {
            if (factor > 1 && !are_few) continue;
            const double place = exponent + decimal_logarithm(factor);
            if (place >= least && place <= greatest) ticks.push_back({place, power_label(factor, exponent)});
        }
    }
    return ticks;
}

/// The largest of 1, 2, 5 times a power of ten that still gives at least four steps.
double round_step(double extent) {
    const double power = power_of_ten(static_cast<int>(std::floor(decimal_logarithm(extent / 4))));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= extent / 4) return factor * power;
    return power;
}

} // namespace

std::vector<Tick> axis_ticks(double least, double greatest, Scale scale) {
    assert(least < greatest);
    if (scale == Scale::Logarithmic) return logarithmic_ticks(least, greatest);
    const double step =
        scale == Scale::Whole ? std::max(1.0, round_step(greatest - least)) : round_step(greatest - least);
    std::vector<Tick> ticks;
    for (double index = std::ceil(least / step); index * step <= greatest; index += 1)
        ticks.push_back({index * step, rounded(index * step + 0.0)}); // + 0.0: no "-0"
    return ticks;
}

} // namespace internode
