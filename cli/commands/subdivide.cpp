// SPDX-License-Identifier: MIT

#include "cli/commands/by_kind.h"
#include "cli/commands/commands.h"
#include "cli/grids/handlers.h"
#include "cli/intervals/curve_output.h"
#include "cli/intervals/limit_output.h"
#include "cli/intervals/polygon.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/curve/refinement.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/io/csv.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/report/picture/curve_picture.h"
#include "internode/text/number.h"
#include <fmt/format.h>

namespace internode::cli {

ExitCode run(const SubdivideOptions& options, const Context& context) {
    return options.is_grid() ? subdivide_grid(options, context) : run_by_kind(options, context);
}

} // namespace internode::cli
