// SPDX-License-Identifier: MIT

#include "cli/grids/grid.h"
#include "cli/grids/handlers.h"
#include "cli/intervals/knots_output.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/io/json/grid_json.h"
#include "internode/io/sheet_files.h"
#include "internode/stencil/automaton.h"
#include "internode/surface/limit.h"
#include "internode/surface/refinement.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

GridSize planned(const Grid& grid, const SubdivideOptions& options) {
    const GridSize size = refined_size(grid, options.steps, options.steps, options.polygon.max_points);
    if (size.exceeded)
        throw failure(ExitCode::Refused,
                      fmt::format("{} steps give more than {} points", options.steps, options.polygon.max_points),
                      "fewer steps, or a larger --max-points");
    return size;
}

/// What is held beside the grid on its way out: its points in space, or with --limit the rows measured along v, and the
/// points with their normals.
std::uint64_t output_bytes(const Grid& grid, const GridSize& size, const SubdivideOptions& options) {
    const std::uint64_t numbers = grid.dimension() + (options.limit ? grid.space_dimension() : 0);
    return size.points * numbers * sizeof(double) * (options.limit && options.normals ? 2 : 1);
}

void print_plan(const Grid& grid, const SubdivideOptions& options) {
    const GridSize size = planned(grid, options);
    std::string text = fmt::format(
        "points {}\nrows {}\ncolumns {}\nbytes of points {}\nbytes of memory {}\n", size.points, size.rows,
        size.columns, size.points * grid.dimension() * sizeof(double), size.bytes + output_bytes(grid, size, options));
    for (const Knots* knots : {&grid.u(), &grid.v()}) {
        const auto cells = cell_states(knots->word(), knots->degree(), knots->ends());
        const StencilAutomaton automaton = make_automaton(knots->system(), knots->degree(), cells, max_states);
        text += fmt::format("states along {} {}\n", knots == &grid.u() ? 'u' : 'v', automaton.state_count());
    }
    write_output("-", text);
}

void check_format(const SubdivideOptions& options, const std::string& format, const Grid& grid) {
    if (format != "json" && grid.space_dimension() > max_mesh_dimension)
        throw failure(ExitCode::Refused,
                      fmt::format("meshes have at most {} coordinates, the points have {}", max_mesh_dimension,
                                  grid.space_dimension()),
                      "use JSON");
    if (options.normals && grid.space_dimension() != 3)
        throw failure(ExitCode::Refused,
                      fmt::format("only points of 3 coordinates have normals, these have {}", grid.space_dimension()));
}

GridSide side(const Knots& knots) {
    return {static_cast<std::size_t>(knots.degree()),
            knots.ends(),
            knots.system().alphabet().names(),
            knots.word(),
            current_lengths(knots),
            exact_origin(knots),
            written_knots(knots)};
}

void write_json(Sink& sink, const Grid& grid, const Context& context) {
    GridDocument document;
    document.version = generator(context).version;
    document.command = context.command_line;
    document.sides = {side(grid.u()), side(grid.v())};
    document.columns = grid.v().size();
    document.rational = grid.rational();
    document.points = {grid.dimension(), grid.points()};
    document.threads = context.apply.threads;
    write_grid_json(sink, document);
}

void write_mesh(Sink& sink, const std::string& format, const Sheet& sheet, const Context& context) {
    const MeshFormat kind = format == "ply" ? MeshFormat::Ply : format == "stl" ? MeshFormat::Stl : MeshFormat::Obj;
    if (const auto problem = mesh_problem(sheet, kind)) throw failure(ExitCode::Refused, *problem);
    const std::vector<std::string> comments{"internode " + generator(context).version, context.command_line};
    if (kind == MeshFormat::Ply)
        write_ply(sink, sheet, comments);
    else if (kind == MeshFormat::Stl)
        write_stl(sink, sheet, comments);
    else
        write_obj(sink, sheet, comments, context.apply.threads);
}

} // namespace

ExitCode subdivide_grid(const SubdivideOptions& options, const Context& context) {
    const std::string format =
        settled_format(context, options.output, {"subdivide", Kind::Grids, ""}, options.limit ? "obj" : "json");
    const LoadedGrid loaded = load_grid(options);
    if (options.plan) {
        if (options.output.file != "-") throw failure(ExitCode::Usage, "--plan writes no file: leave -o out");
        print_plan(loaded.grid, options);
        return ExitCode::Success;
    }
    check_format(options, format, loaded.grid);
    const GridSize size = planned(loaded.grid, options);
    Output output(options.output.file);
    const int steps = static_cast<int>(options.steps);
    const Grid fine = refine(loaded.grid, steps, steps, context.apply);
    if (context.verbose)
        say(context, fmt::format("{} by {} points from {} by {}\n", size.rows, size.columns, loaded.grid.u().size(),
                                 loaded.grid.v().size()));
    if (format == "json")
        write_json(output.sink(), fine, context);
    else if (options.limit)
        write_mesh(output.sink(), format,
                   surface_limit(loaded.grid, fine, options.normals ? Normals::Unit : Normals::None).sheet, context);
    else
        write_mesh(output.sink(), format, control_sheet(fine), context);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
