// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "internode/curve/curve.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

std::string with_examples(const std::string& what, const std::string& first, const std::string& second) {
    return fmt::format("{}\n\nExamples:\n  internode {}\n  internode {}\n", what, first, second);
}

CLI::App* CommandReader::add(const std::string& name, const std::string& description) {
    CLI::App* command = app_.add_subcommand(name, description);
    command->allow_extras();
    command->set_help_flag("-h,--help", "This text");
    command->get_formatter()->column_width(34);
    add_common(command);
    return command;
}

void CommandReader::add_common(CLI::App* app) {
    app->add_flag("-q,--quiet", common_.quiet, "Only errors on stderr");
    app->add_flag("-v,--verbose", common_.verbose, "Say more on stderr");
    app->add_option("--color", color_, "auto, always or never (NO_COLOR counts)")
        ->check(CLI::IsMember({"auto", "always", "never"}));
}

void CommandReader::add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon) {
    app->add_option("GRAMMAR", grammar.place,
                    with_polygon ? "Grammar file, @name of a bundled one, or - (left out with -e)"
                                 : "Grammar file, @name of a bundled one, or -");
    app->add_option("-e,--expression", grammar.expression, "The grammar itself: -e 'L->SL, S->L'");
}

void CommandReader::add_output(CLI::App* app, OutputTarget& output, const std::vector<std::string>& formats) {
    app->add_option("-o,--output", output.file, "Output file, - for stdout (default); the extension names the format");
    app->add_option("--format", output.format, fmt::format("{}", fmt::join(formats, ", ")))
        ->check(CLI::IsMember(formats));
    const auto has = [&formats](const char* name) { return std::ranges::find(formats, name) != formats.end(); };
    if (has("json"))
        app->add_flag_callback(
            "--json", [&output] { output.format = "json"; }, "Same as --format json");
}

/// With `sides`, -d takes the two degrees of a grid too.
void CommandReader::add_polygon(CLI::App* app, PolygonOptions& polygon, std::array<GridSideOptions, 2>* sides) {
    app->add_option("POLYGON", polygon.place, "Control polygon: CSV, JSON or free-form OBJ file, or -");
    const auto read_degree = [&polygon, sides](const std::string& text) {
        const std::vector<int> said = degrees(text);
        polygon.degree = said.front();
        if (sides != nullptr) (*sides)[0].degree = said.front();
        if (sides != nullptr) (*sides)[1].degree = said.back();
    };
    const auto degree_problem = [most = sides == nullptr ? 1U : 2U](const std::string& text) {
        const std::size_t said = degrees(text).size();
        return said >= 1 && said <= most ? std::string()
                                         : fmt::format("`{}` is not a degree from 1 to {}", text, max_degree);
    };
    app->add_option_function<std::string>("-d,--degree", read_degree,
                                          "Degree of the B-spline, 1 to 12 (default: the JSON's)")
        ->type_name("D")
        ->check(CLI::Validator(degree_problem, ""));
    app->add_option("--word", polygon.word, "The intervals: N letters closed, N+d open ('0^3 (LS)^9 0^3')")
        ->check(CLI::Validator(empty_word_problem, ""));
    app->add_flag("--repeat", polygon.repeat, "Repeat the word's letters as often as the points need");
    auto* closed = app->add_flag_callback(
        "--closed", [&polygon] { polygon.ends = EndsOption::Closed; }, "The polygon and its word are circular");
    auto* open = app->add_flag_callback(
        "--open", [&polygon] { polygon.ends = EndsOption::Open; }, "The word has d letters more than points");
    auto* clamped = app->add_flag_callback(
        "--clamped", [&polygon] { polygon.ends = EndsOption::Clamped; },
        "The word is the domain's (N-d letters); d zeros are put at each end");
    closed->excludes(open)->excludes(clamped);
    open->excludes(clamped);
    app->add_flag("--rational", polygon.rational, "The last coordinate of a point is its weight (JSON: \"weights\")");
    app->add_option_function<std::string>(
           "--element", [&polygon](const std::string& text) { polygon.element = whole_number(text); },
           "Which curve or surface of an OBJ file, from 1")
        ->type_name("K")
        ->check(CLI::Validator(whole_number_problem, ""));
    add_count(app, "--max-points", polygon.max_points, "Refuse more points than this (default 100000000)");
}

void CommandReader::add_grid(CLI::App* app, SubdivideOptions& subdivide) {
    auto& [u, v] = subdivide.sides;
    app->add_option("--u", u.grammar, "A grid: the grammar along u, the rows; beside it one JSON file (-d DU,DV)");
    app->add_option("--v", v.grammar, "A grid: the grammar along v, within a row");
    for (GridSideOptions* side : {&u, &v})
        app->add_option(side == &u ? "--word-u" : "--word-v", side->word, "A grid: --word for this direction")
            ->check(CLI::Validator(empty_word_problem, ""));
    app->add_flag("--normals", subdivide.normals, "A grid, with --limit: unit normals too (OBJ, PLY)");
}

CLI::Option* CommandReader::add_count(CLI::App* app, const std::string& name, std::uint64_t& count,
                                      const std::string& what) {
    const auto read = [&count](const std::string& text) { count = whole_number(text).value_or(0); };
    return app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

void CommandReader::add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what) {
    add_count(app, "-n,--steps", steps, what)->required();
}

} // namespace internode::cli
