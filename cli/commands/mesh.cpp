// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/io/mesh/mesh_writers.h"
#include "internode/mesh/mesh_repair.h"
#include "internode/report/json/mesh_json.h"
#include "internode/report/text/mesh_text.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

MeshFile load_mesh(const std::string& place) {
    const LoadedText input = load_bytes(place);
    ParsedMesh parsed = read_mesh(input.text, input.source);
    if (!parsed.file) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return *std::move(parsed.file);
}

void write_mesh(Sink& sink, const std::string& format, const PolygonMesh& mesh, const Context& context) {
    const std::vector<std::string> comments{"internode " + generator(context).version, context.command_line};
    if (format == "obj")
        write_obj(sink, mesh, comments);
    else if (format == "off")
        write_off(sink, mesh, comments);
    else
        write_ply(sink, mesh, comments);
}

ExitCode repair(const MeshOptions& options, const std::string& format, const Context& context) {
    const MeshFile file = load_mesh(options.file);
    const RepairedPolygons result = repaired(file.mesh);
    Output output(options.output.file);
    write_mesh(output.sink(), format, result.mesh, context);
    output.commit();
    say(context, fmt::format("{}: {}\n", printable(file.source), repairs_text(result.done)));
    if (format != "obj" && !(result.mesh.creases.empty() && result.mesh.corners.empty()))
        say(context, fmt::format("warning: {} does not say what is sharp\n", find_format(format)->called));
    return ExitCode::Success;
}

} // namespace

ExitCode run(const MeshOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"mesh", {}, options.repair ? "--repair" : ""});
    if (options.repair) return repair(options, format, context);
    const MeshFile file = load_mesh(options.file);
    const MeshReport report = mesh_report(file);
    Output output(options.output.file);
    if (format == "json")
        write_mesh_json(output.sink(), report, generator(context));
    else
        output.sink().write(mesh_text(report));
    output.commit();
    return report.faults.empty() ? ExitCode::Success : ExitCode::NotValid;
}

} // namespace internode::cli
