// SPDX-License-Identifier: MIT

#include "cli/curve_output.h"

#include "internode/io/curve_json.h"

namespace internode::cli {
namespace {

std::vector<CurveLength> current_lengths(const Curve& curve) {
    const IntervalSystem& system = curve.system();
    const Number scale = pow(system.ratio(), -curve.step());
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

} // namespace

void write_curve(Sink& sink, const Curve& curve, const Context& context) {
    CurveDocument document;
    document.version = generator(context).version;
    document.command = context.command_line;
    document.degree = static_cast<std::size_t>(curve.degree());
    document.ends = curve.ends();
    document.symbols = curve.system().alphabet().names();
    document.word = curve.word();
    document.lengths = current_lengths(curve);
    document.points = {curve.dimension(), curve.points()};
    write_curve_json(sink, document);
}

} // namespace internode::cli
