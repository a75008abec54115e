// SPDX-License-Identifier: MIT

#include "cli/intervals/knots_output.h"

#include "internode/curve/parameter.h"

namespace internode::cli {

namespace {

/// Knots are summed in pairs of doubles: 6 MB of them stay within what a plan of 64 MB leaves free.
constexpr std::size_t most_written_knots = 250'000;

std::vector<std::string> exact_coefficients(const Number& number, const NumberField& field) {
    std::vector<std::string> texts;
    for (const Rational& coefficient : number.coefficients(field)) texts.push_back(to_string(coefficient));
    return texts;
}

} // namespace

std::vector<CurveLength> current_lengths(const Knots& knots) {
    const IntervalSystem& system = knots.system();
    const Number scale = pow(system.ratio(), -knots.step());
    std::vector<CurveLength> lengths;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        if (!system.occurs(to_symbol(i))) continue;
        const Number length = system.lengths()[i] * scale;
        lengths.push_back({.symbol = system.alphabet().names()[i],
                           .value = length.to_double(),
                           .exact = exact_coefficients(length, system.field())});
    }
    return lengths;
}

CurveOrigin exact_origin(const Knots& knots) {
    return {knots.origin().to_double(), exact_coefficients(knots.origin(), knots.system().field())};
}

std::vector<double> written_knots(const Knots& knots) {
    const std::size_t count = knots.size() + static_cast<std::size_t>(knots.degree()) + 1;
    return count > most_written_knots ? std::vector<double>() : knot_positions(knots);
}

} // namespace internode::cli
