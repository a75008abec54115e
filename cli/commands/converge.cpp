// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/intervals/polygon.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/curve/convergence.h"
#include "internode/curve/refinement.h"
#include "internode/report/json/convergence_json.h"
#include "internode/report/page/convergence_page.h"
#include "internode/report/picture/curve_picture.h"
#include "internode/report/text/convergence_text.h"

#include <fmt/format.h>

namespace internode::cli {

namespace {

/// Steps drawn in the page's picture: enough to see the polygon settle on the curve.
constexpr int drawn_steps = 1;

std::string page_text(const SettledCurve& loaded, const Convergence& convergence, const Context& context) {
    const Curve& curve = loaded.curve;
    Refinement refinement(curve);
    refinement.advance(drawn_steps);
    const std::string picture =
        curve_picture(planar_curve(curve, refinement, {}), {loaded.source, generator(context), SvgPlace::Page});
    return convergence_page({convergence, curve.system(), loaded.source, picture, generator(context)});
}

} // namespace

ExitCode run(const ConvergeOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"converge", Kind::Intervals, ""});
    if (options.html == "-" && options.output.file == "-")
        throw failure(ExitCode::Usage, "report and page cannot both go to stdout", "give one of them a file");
    const IntervalSystem system = load_system(options.grammar);
    const SettledCurve loaded = load_polynomial_curve(system, options.polygon);
    if (refined_size(loaded.curve, options.steps, options.polygon.max_points).exceeded)
        throw failure(ExitCode::Refused,
                      fmt::format("{} steps give more than {} points", options.steps, options.polygon.max_points),
                      "fewer steps, or a larger --max-points");
    Output output(options.output.file);
    std::optional<Output> page;
    if (!options.html.empty()) page.emplace(options.html);
    ConvergenceOptions measure;
    measure.steps = static_cast<int>(options.steps);
    measure.tolerance = options.tolerance;
    measure.max_points = options.polygon.max_points;
    const Convergence convergence = measure_convergence(loaded.curve, measure);
    output.sink().write(format == "json" ? convergence_json(convergence, loaded.curve.system(), generator(context))
                                         : convergence_text(convergence, loaded.curve.system()));
    output.commit();
    if (page) {
        page->sink().write(page_text(loaded, convergence, context));
        page->commit();
    }
    return ExitCode::Success;
}

} // namespace internode::cli
