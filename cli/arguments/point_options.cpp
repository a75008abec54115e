// SPDX-License-Identifier: MIT
//
// The options of `subdivide` that only point grammars have.

#include "cli/arguments/command_reader.h"

namespace internode::cli {

CLI::Option* CommandReader::add_settings(CLI::App* app, std::vector<std::string>& settings) {
    return app->add_option("--set", settings, "The value of a constant, --set w=1/8 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

void CommandReader::add_point(CLI::App* subdivide) {
    PointOptions& point = subdivide_.point;
    put(add_settings(subdivide, point.settings), for_points());
    put(subdivide->add_option("--query", point.queries, "The parameters of a query module, --query C=1/4")
            ->type_name("NAME=V,V")
            ->allow_extra_args(false),
        for_points());
    put(add_number(subdivide, "--phase", point.phase, "The module at which strict predecessors begin to part it"),
        for_points());
    put(add_number(subdivide, "--seed", point.seed,
                   "Of stochastic rules (default 0); every polygon of a file begins anew"),
        for_points());
    put(add_number(subdivide, "--max-modules", point.max_modules,
                   "Refuse more modules, of all polygons of a file (default 10000000)"),
        for_points());
    put(subdivide->add_flag("--trace", point.trace, "The word after every step, and every interpretation"),
        for_points());
    put(subdivide->add_flag("--tree", point.tree, "The derivation tree of all steps (SVG)"), for_points());
    Belonging interpreter = for_points({"--trace", "--tree"});
    interpreter.places.front().formats = {"csv", "json", "npy", "obj", "text"};
    interpreter.refusals = {{.kinds = {Kind::Points}, .format = "svg", .hint = "pictures are always interpreted"}};
    put(subdivide->add_flag("--interpreter", point.interpreter, "Derive module by module, as the papers define it"),
        interpreter);
}

} // namespace internode::cli
