// SPDX-License-Identifier: MIT

#include "cli/command_reader.h"

#include "cli/option_checks.h"

namespace internode::cli {

namespace {

void add_number(CLI::App* app, const std::string& name, std::optional<std::uint64_t>& number, const std::string& what) {
    const auto read = [&number](const std::string& text) { number = whole_number(text); };
    app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

} // namespace

void CommandReader::add_point(CLI::App* app, PointOptions& point) {
    app->add_option("--set", point.settings, "A point grammar: the value of a constant, --set w=1/8 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app->add_option("--query", point.queries, "A point grammar: the parameters of a query module, --query C=1/4")
        ->type_name("NAME=V,V")
        ->allow_extra_args(false);
    add_number(app, "--phase", point.phase,
               "A point grammar: the module at which strict predecessors begin to part it");
    add_number(app, "--seed", point.seed, "A point grammar: of its stochastic rules (default 0)");
    add_number(app, "--max-modules", point.max_modules, "A point grammar: refuse longer words (default 10000000)");
    app->add_flag("--trace", point.trace, "A point grammar: the word after every step, and every interpretation");
    app->add_flag("--tree", point.tree, "A point grammar: the derivation tree of all steps (SVG)");
    app->add_flag("--interpreter", point.interpreter,
                  "A point grammar: derive module by module, as the papers define it");
}

} // namespace internode::cli
