// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "internode/text/number.h"

namespace internode::cli {

void CommandReader::add_curve_commands() {
    CLI::App* subdivide =
        add("subdivide",
            with_examples("Refine a control polygon or, with --u and --v, a grid: the same curve or surface\n"
                          "over more and more intervals; or rewrite a polygon by a point grammar.",
                          "subdivide @fibonacci data/curves/iceland-coast.csv -d 3 -n 4 --closed --word LS --repeat "
                          "-o coast.svg",
                          "subdivide --u @fibonacci --v @silver-mean data/grids/wave.json -n 3 -o wave.ply"));
    add_grammar(subdivide, subdivide_.grammar, true);
    add_polygon(subdivide, subdivide_.polygon, &subdivide_.sides);
    add_grid(subdivide, subdivide_);
    add_output(subdivide, subdivide_.output, {"csv", "json", "npy", "obj", "svg", "ply", "stl", "text"});
    subdivide->add_flag_callback(
        "--svg", [this] { subdivide_.output.format = "svg"; }, "Same as --format svg");
    add_steps(subdivide, subdivide_.steps, "Steps of subdivision; cycles of a point grammar");
    add_point(subdivide, subdivide_.point);
    subdivide->add_flag("--limit", subdivide_.limit, "The curve or surface itself at the distinct knots");
    subdivide->add_flag("--derivatives", subdivide_.derivatives,
                        "With --limit: two derivatives, tangent and curvature too");
    subdivide->add_option("--axes", subdivide_.axes, "Coordinates drawn in SVG: i,j counted from 1");
    add_count(subdivide, "--threads", threads_, "Threads, 0 for all (default); they change no byte of the result");
    subdivide->add_flag("--plan", subdivide_.plan, "Say points, bytes, memory and states, and stop");
    commands_.push_back({subdivide, [this] { return Request(subdivide_); }});

    CLI::App* converge = add(
        "converge", with_examples("How fast the control polygons approach the curve: errors, ratios, exact constant,\n"
                                  "guaranteed envelope, steps for a tolerance, comparison with uniform bisection.",
                                  "converge @fibonacci data/curves/fibonacci-open.json -n 8",
                                  "converge @fibonacci data/curves/fibonacci-open.json -n 6 --html report.html"));
    add_grammar(converge, converge_.grammar, true);
    add_polygon(converge, converge_.polygon, nullptr);
    add_output(converge, converge_.output, {"text", "json"});
    add_steps(converge, converge_.steps, "Steps of subdivision");
    converge
        ->add_option_function<std::string>(
            "--tolerance", [this](const std::string& text) { converge_.tolerance = parse_double(text); },
            "How many steps until the envelope is below this")
        ->check(CLI::Validator(positive_number, ""));
    converge->add_option("--html", converge_.html, "Write the report as one self-contained page");
    commands_.push_back({converge, [this] { return Request(converge_); }});
}

void CommandReader::add_pyramid_commands() {
    add_reverse_command();
    add_compose_command();
}

void CommandReader::add_reverse_command() {
    CLI::App* reverse = add(
        "reverse",
        with_examples("Take a polygon apart: a coarse polygon and the details of every step back to it.\n"
                      "--word names the intervals of the coarse polygon. With a point grammar of a ring: by its local\n"
                      "reverse rules, or by its own rules when they reduce.",
                      "reverse @fibonacci data/curves/iceland-coast.csv -d 3 -n 5 --closed --word LSLLS "
                      "--repeat --resample --picture levels.svg",
                      "reverse @fibonacci data/curves/leaf.csv -d 2 -n 2 --closed --word LS --repeat "
                      "--keep 5 -o pyramid.json"));
    add_grammar(reverse, reverse_.grammar, true);
    add_polygon(reverse, reverse_.polygon, nullptr);
    add_output(reverse, reverse_.output, {"text", "json", "csv", "svg", "lsys"});
    const auto levels = [this](const std::string& text) { reverse_.levels = whole_number(text); };
    reverse->add_option_function<std::string>("-n,--levels", levels, "Steps down (default: what the word asks for)")
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
    reverse->add_flag_callback(
        "--local", [this] { reverse_.local = true; }, "Local filters instead of least squares");
    add_reverse_rules(reverse);
    add_details(reverse);
    reverse->add_option("--coarse", reverse_.coarse, "Write the coarse polygon: CSV or JSON by the extension");
    reverse->add_option("--picture", reverse_.picture, "Write a picture of all levels (SVG)");
    commands_.push_back({reverse, [this] { return Request(reverse_); }});
}

/// The rules that `reverse` derives, or is given.
void CommandReader::add_reverse_rules(CLI::App* reverse) {
    const auto window = [this](const std::string& text) { reverse_.window = whole_number(text); };
    reverse
        ->add_option_function<std::string>(
            "--window", window,
            "Intervals of a local filter (default 5); fine points of a point grammar's reverse rule (the fewest)")
        ->type_name("N")
        ->check(CLI::Range(1, 64));
    const auto phase = [this](const std::string& text) { reverse_.phase = whole_number(text); };
    reverse
        ->add_option_function<std::string>("--phase", phase,
                                           "A point grammar: the point at which the ring begins to be parted")
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
    add_settings(reverse, reverse_.settings);
    reverse->add_flag("--rules", reverse_.rules, "A point grammar: write its reverse rules as a grammar, and stop");
}

/// Which details `reverse` keeps, and what it may do to the polygon first.
void CommandReader::add_details(CLI::App* reverse) {
    const auto keep = [this](const std::string& text) { reverse_.keep = whole_number(text); };
    auto* threshold = reverse->add_option_function<std::string>(
        "--threshold", [this](const std::string& text) { reverse_.threshold = parse_double(text); },
        "Keep only details at least this long");
    threshold->check(CLI::Validator(positive_number, ""));
    auto* count =
        reverse->add_option_function<std::string>("--keep", keep, "Keep only this many of the longest details");
    count->type_name("N")->check(CLI::Validator(whole_number_problem, ""))->excludes(threshold);
    reverse->add_flag("--unclamped", reverse_.unclamped,
                      "Leave the ends of an open curve as they are (ill-conditioned) instead of clamping them");
    auto* resample = reverse->add_flag_callback(
        "--resample", [this] { reverse_.fit = FitOption::Resample; },
        "Bring the polygon to the nearest possible number of points, at equal steps of chord length");
    auto* cut = reverse->add_flag_callback(
        "--cut", [this] { reverse_.fit = FitOption::Cut; }, "Drop points from its end until their number is possible");
    cut->excludes(resample);
}

void CommandReader::add_compose_command() {
    CLI::App* compose =
        add("compose", with_examples("Put a polygon together again from the pyramid that reverse wrote.",
                                     "compose data/pyramids/leaf.json",
                                     "compose data/pyramids/leaf.json --level 0 -o coarse.json"));
    compose->add_option("PYRAMID", compose_.pyramid, "JSON of format internode-pyramid, or -")->required();
    add_output(compose, compose_.output, {"csv", "json", "npy", "obj"});
    const auto level = [this](const std::string& text) { compose_.level = whole_number(text); };
    compose->add_option_function<std::string>("--level", level, "This level, 0 is the coarse one (default: the finest)")
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
    add_count(compose, "--max-points", compose_.max_points, "Refuse more points than this (default 100000000)");
    commands_.push_back({compose, [this] { return Request(compose_); }});
}

} // namespace internode::cli
