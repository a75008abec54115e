// SPDX-License-Identifier: MIT

#include "cli/intervals/curve_output.h"

#include "cli/intervals/lengths.h"
#include "internode/io/json/curve_json.h"

namespace internode::cli {

void write_curve(Sink& sink, const Curve& curve, const Context& context) {
    write_curve(sink, curve, {curve.dimension(), curve.points()}, false, context);
}

void write_curve(Sink& sink, const Curve& curve, const PointsView& points, bool weighted, const Context& context) {
    CurveDocument document;
    document.version = generator(context).version;
    document.command = context.command_line;
    document.degree = static_cast<std::size_t>(curve.degree());
    document.ends = curve.ends();
    document.symbols = curve.system().alphabet().names();
    document.word = curve.word();
    document.lengths = current_lengths(curve.knots());
    document.points = points;
    document.weighted = weighted;
    write_curve_json(sink, document);
}

} // namespace internode::cli
