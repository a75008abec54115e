// SPDX-License-Identifier: MIT

#include "cli/intervals/curve_output.h"

#include "cli/intervals/knots_output.h"
#include "cli/shell/generator.h"

namespace internode::cli {

void write_curve(Sink& sink, const Curve& curve, const Context& context) {
    write_curve_json(sink, curve_document(curve, {curve.dimension(), curve.points()}, false, context));
}

CurveDocument curve_document(const Curve& curve, const PointsView& points, bool weighted, const Context& context) {
    CurveDocument document;
    document.version = generator(context).version;
    document.command = context.command_line;
    document.degree = static_cast<std::size_t>(curve.degree());
    document.ends = curve.ends();
    document.symbols = curve.system().alphabet().names();
    document.word = curve.word();
    document.lengths = current_lengths(curve.knots());
    document.origin = exact_origin(curve.knots());
    document.knots = written_knots(curve.knots());
    document.points = points;
    document.weighted = weighted;
    document.threads = context.apply.threads;
    return document;
}

} // namespace internode::cli
