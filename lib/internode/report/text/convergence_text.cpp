// SPDX-License-Identifier: MIT

#include "internode/report/text/convergence_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <cmath>
#include <fmt/format.h>

namespace internode {

namespace {

std::string steps_table(const Convergence& convergence) {
    TextTable table({Align::Right, Align::Right, Align::Right, Align::Right, Align::Right, Align::Right}, 2, 3);
    table.row({"step", "points", "largest interval", "error", "ratio", "envelope"});
    for (const ConvergenceStep& step : convergence.steps)
        table.row({std::to_string(step.step), std::to_string(step.points), rounded(step.largest_interval),
                   rounded(step.error), step.ratio ? rounded(*step.ratio) : "-", rounded_up(step.envelope)});
    return table.text();
}

std::string bisection_table(const Convergence& convergence) {
    TextTable table({Align::Right, Align::Right}, 2, 3);
    table.row({"points", "error"});
    for (const BisectionStep& step : convergence.bisection)
        table.row({std::to_string(step.points), rounded(step.error)});
    return table.text();
}

} // namespace

std::string depth_sentence(const Convergence& convergence) {
    if (!convergence.depth) return {};
    const ToleranceDepth& depth = *convergence.depth;
    const std::string tolerance = rounded(depth.tolerance);
    if (!depth.steps) return "No number of steps within reach guarantees an error of at most " + tolerance + ".";
    std::string text = std::to_string(*depth.steps) + (*depth.steps == 1 ? " step" : " steps");
    return text + (depth.measured ? " guarantee" : " are expected to guarantee") + " an error of at most " + tolerance +
           (depth.measured ? " (measured envelope)." : " (extrapolated by 1/ρ² a step).");
}

std::string bisection_sentence(const Convergence& convergence) {
    const std::optional<double> points = bisection_points(convergence);
    if (!points || convergence.steps.size() < 2) return {};
    const ConvergenceStep& last = convergence.steps.back();
    // Nothing to compare when bisection is the scheme itself.
    if (std::abs(*points - static_cast<double>(last.points)) < 1) return {};
    return "An error of " + rounded(last.error) + " takes " + std::to_string(last.points) + " points here, about " +
           fmt::format("{:.0f}", *points) + " under uniform bisection.";
}

std::string convergence_text(const Convergence& convergence, const IntervalSystem& system) {
    const std::string& name = system.grammar().name;
    const std::string& ratio = system.ratio_name();
    std::string text = (name.empty() ? "The system" : printable(name)) + ", degree " +
                       std::to_string(convergence.degree) + ": distance of the control polygon from the curve\n\n";
    text += steps_table(convergence);
    text += "\n  expected ratio   1/" + ratio +
            "² = " + number_text(convergence.expected_ratio, system.field(), ratio) + "\n";
    text += "  constant C*      " + number_text(convergence.constant.value, system.field(), ratio);
    if (!convergence.constant.word.empty())
        text += ", attained at " + printable(to_string(convergence.constant.word, system.alphabet()));
    text += "\n";
    if (const std::string depth = depth_sentence(convergence); !depth.empty()) text += "  " + wrapped(depth, 2) + "\n";
    if (convergence.bisection.empty()) return text;
    text += "\nThe same curve bisected uniformly:\n\n" + bisection_table(convergence);
    if (const std::string cost = bisection_sentence(convergence); !cost.empty())
        text += "\n  " + wrapped(cost, 2) + "\n";
    return text;
}

} // namespace internode
