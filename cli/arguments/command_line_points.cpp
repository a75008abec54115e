// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"

namespace internode::cli {

namespace {

void add_number(CLI::App* app, const std::string& name, std::optional<std::uint64_t>& number, const std::string& what) {
    const auto read = [&number](const std::string& text) { number = whole_number(text); };
    app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

} // namespace

void CommandReader::add_settings(CLI::App* app, std::vector<std::string>& settings) {
    app->add_option("--set", settings, "A point grammar: the value of a constant, --set w=1/8 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

void CommandReader::add_point(CLI::App* app, PointOptions& point) {
    add_settings(app, point.settings);
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

void CommandReader::add_infer() {
    CLI::App* infer = add(
        "infer", with_examples("From a subdivision matrix, new points = matrix * old points, to a point grammar.\n"
                               "A closed curve's matrix has m n rows and n columns; --open takes one whose first and\n"
                               "last rows are different. The report stands in the comments of the grammar.",
                               "infer data/matrices/chaikin.csv",
                               "infer data/matrices/chaikin-open.csv --open --long -o chaikin-open.lsys"));
    infer->add_option("MATRIX", infer_.matrix, "CSV of fractions (3/4, 1/4, 0) or MatrixMarket, or -")->required();
    add_output(infer, infer_.output, {"lsys"});
    infer
        ->add_option_function<std::string>(
            "--shift", [this](const std::string& text) { infer_.shift = integer(text); },
            "Old point i becomes the new points from m i + D on (default: the recommended one)")
        ->type_name("D")
        ->check(CLI::Validator(integer_problem, ""));
    infer->add_flag("--open", infer_.open, "An open curve: # at both ends, rules for the points near them");
    infer->add_flag("--long", infer_.long_form, "With --open: rules that need no order, at most one fits a point");
    infer->add_option("--name", infer_.name, "The name of the grammar (default: that of the file)");
    commands_.push_back({infer, [this] { return Request(infer_); }});
}

} // namespace internode::cli
