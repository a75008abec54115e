// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"

namespace internode::cli {

void CommandReader::add_infer() {
    CLI::App* infer = add(
        "infer", with_examples("From a subdivision matrix, new points = matrix * old points, to a point grammar.\n"
                               "A closed curve's matrix has m n rows and n columns; --open takes one whose first and\n"
                               "last rows are different. The report stands in the comments of the grammar.",
                               "infer data/matrices/chaikin.csv",
                               "infer data/matrices/chaikin-open.csv --open --long -o chaikin-open.lsys"));
    infer->add_option("MATRIX", infer_.matrix, "CSV of fractions (3/4, 1/4, 0) or MatrixMarket, or -")->required();
    add_output(infer, infer_.output);
    infer
        ->add_option_function<std::string>(
            "--shift", [this](const std::string& text) { infer_.shift = integer(text); },
            "Old point i becomes the new points from m i + D on (default: the recommended one)")
        ->type_name("D")
        ->check(CLI::Validator(integer_problem, ""));
    infer->add_flag("--open", infer_.open, "An open curve: # at both ends, rules for the points near them");
    put(infer->add_flag("--long", infer_.long_form, "With --open: rules that need no order, at most one fits a point"),
        {.places = {{.with = {"--open"}}}});
    infer->add_option("--name", infer_.name, "The name of the grammar (default: that of the file)");
    commands_.push_back({infer, [this] { return Request(infer_); }});
}

} // namespace internode::cli
