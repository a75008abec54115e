// SPDX-License-Identifier: MIT
//
// The options that describe a polygon: its file, its degree, its word and its ends.

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "internode/curve/knots.h"

#include <fmt/format.h>

namespace internode::cli {

CLI::Option* CommandReader::add_degree(CLI::App* app, std::size_t most,
                                       const std::function<void(const std::vector<int>&)>& take) {
    const auto problem = [most](const std::string& text) {
        const std::size_t said = degrees(text).size();
        return said >= 1 && said <= most ? std::string()
                                         : fmt::format("`{}` is not a degree from 1 to {}", text, max_degree);
    };
    return app
        ->add_option_function<std::string>(
            "-d,--degree", [take](const std::string& text) { take(degrees(text)); },
            "Degree of the B-spline, 1 to 12 (default: the JSON's)")
        ->type_name("D")
        ->check(CLI::Validator(problem, ""));
}

CLI::Option* CommandReader::add_word(CLI::App* app, const std::string& name, std::string& word,
                                     const std::string& what) {
    return app->add_option(name, word, what)->check(CLI::Validator(empty_word_problem, ""));
}

void CommandReader::add_ends(CLI::App* app, PolygonOptions& polygon, const Belonging& belonging) {
    auto* closed = app->add_flag_callback(
        "--closed", [&polygon] { polygon.ends = EndsOption::Closed; }, "The polygon and its word are circular");
    auto* open = app->add_flag_callback(
        "--open", [&polygon] { polygon.ends = EndsOption::Open; }, "The word has d letters more than points");
    auto* clamped = app->add_flag_callback(
        "--clamped", [&polygon] { polygon.ends = EndsOption::Clamped; },
        "The word is the domain's (N-d letters); d zeros are put at each end");
    closed->excludes(open)->excludes(clamped);
    open->excludes(clamped);
    for (CLI::Option* ends : {closed, open, clamped}) put(ends, belonging);
}

void CommandReader::add_polygon(CLI::App* app, PolygonOptions& polygon, const PolygonBelongings& belongings) {
    app->add_option("POLYGON", polygon.place, "Control polygon: CSV, JSON or OBJ file, or -");
    put(add_word(app, "--word", polygon.word, "The intervals: N letters closed, N+d open ('0^3 (LS)^9 0^3')"),
        belongings.word);
    put(app->add_flag("--repeat", polygon.repeat, "Repeat the word's letters as often as the points need"),
        belongings.repeat);
    add_ends(app, polygon, belongings.ends);
    put(app->add_flag("--rational", polygon.rational,
                      "The last coordinate of a point is its weight (JSON: \"weights\")"),
        belongings.weights);
    put(app->add_option_function<std::string>(
               "--element", [&polygon](const std::string& text) { polygon.element = whole_number(text); },
               "One polygon alone of a file that has several, from 1")
            ->type_name("K")
            ->check(CLI::Validator(whole_number_problem, "")),
        belongings.element);
    put(add_count(app, "--max-points", polygon.max_points, "Refuse more points than this (default 100000000)"),
        belongings.max_points);
}

} // namespace internode::cli
