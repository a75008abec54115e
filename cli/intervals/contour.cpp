// SPDX-License-Identifier: MIT

#include "cli/intervals/contour.h"

#include "cli/intervals/polygon.h"
#include "cli/shell/load.h"
#include "cli/shell/settled.h"
#include "internode/input/polygon_file.h"

namespace internode::cli {

SettledContour load_contour(const IntervalSystem& system, const ReverseOptions& options) {
    const LoadedText input = load_text(options.polygon.place);
    const InputPolygon polygon =
        value_of(polygon_of_file(input.text, input.source, options.polygon.element, options.polygon.threads));
    return value_of(settle_contour(system, polygon,
                                   {.curve = curve_options(options.polygon),
                                    .levels = options.levels,
                                    .fit = options.fit,
                                    .unclamped = options.unclamped,
                                    .max_points = options.polygon.max_points}));
}

} // namespace internode::cli
