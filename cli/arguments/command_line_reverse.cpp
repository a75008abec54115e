// SPDX-License-Identifier: MIT
//
// The commands that take a polygon apart and put it together again.

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "cli/arguments/settlement.h"
#include "internode/text/number.h"

namespace internode::cli {
namespace {

/// Of both kinds, but not where the rules alone are asked for.
Belonging for_reversal() {
    return {.places = {{.kinds = {Kind::Intervals}}, {.kinds = {Kind::Points}, .without = {"--rules"}}}};
}

PolygonBelongings belongings_of_reverse() {
    PolygonBelongings all;
    all.degree = for_intervals(rules_say_everything());
    all.degree.called = "-d";
    all.word = for_intervals(rules_say_everything());
    all.repeat = all.word;
    all.ends = all.word;
    all.ends.called = "--closed, --open or --clamped";
    all.max_points = all.word;
    all.weights = for_reversal();
    all.element = for_reversal();
    return all;
}

} // namespace

void CommandReader::add_reverse() {
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
    add_output(reverse, reverse_.output);
    add_quiet(reverse);
    const PolygonBelongings belongings = belongings_of_reverse();
    put(add_degree(reverse, 1, [this](const std::vector<int>& said) { reverse_.polygon.degree = said.front(); }),
        belongings.degree);
    add_polygon(reverse, reverse_.polygon, belongings);
    const auto put_reversal = [this](CLI::Option* option) { belongings_[option] = for_reversal(); };
    put_reversal(add_number(reverse, "-n,--levels", reverse_.levels, "Steps down (default: what the word asks for)"));
    add_reverse_rules(reverse);
    add_details(reverse);
    put_reversal(
        reverse->add_option("--coarse", reverse_.coarse, "Write the coarse polygon: CSV or JSON by the extension"));
    put_reversal(reverse->add_option("--picture", reverse_.picture, "Write a picture of all levels (SVG)"));
    commands_.push_back({reverse, [this] {
                             settle(reverse_);
                             return Request(reverse_);
                         }});
}

/// The rules that `reverse` derives, or is given.
void CommandReader::add_reverse_rules(CLI::App* reverse) {
    put(reverse->add_flag("--local", reverse_.local, "Local filters instead of least squares"),
        for_intervals("reverse rules of a point grammar are local"));
    CLI::Option* window = reverse->add_option_function<std::string>(
        "--window", [this](const std::string& text) { reverse_.window = whole_number(text); },
        "Intervals of a local filter (--local, default 5); fine points of a point grammar's reverse rule (the fewest)");
    window->type_name("N")->check(CLI::Range(1, 64));
    belongings_[window] = {.places = {{.kinds = {Kind::Intervals}, .with = {"--local"}}, {.kinds = {Kind::Points}}}};
    put(add_number(reverse, "--phase", reverse_.phase, "The point at which the ring begins to be parted"),
        for_points({"--rules"}));
    put(add_settings(reverse, reverse_.settings), for_points());
    put(reverse->add_flag("--rules", reverse_.rules, "Write the reverse rules as a grammar, and stop"), for_points());
}

/// Which details `reverse` keeps, and what it may do to the polygon first.
void CommandReader::add_details(CLI::App* reverse) {
    const Belonging details = for_intervals(rules_say_everything());
    CLI::Option* threshold = reverse->add_option_function<std::string>(
        "--threshold", [this](const std::string& text) { reverse_.threshold = parse_double(text); },
        "Keep only details at least this long");
    threshold->check(CLI::Validator(positive_number, ""));
    put(threshold, details);
    put(add_number(reverse, "--keep", reverse_.keep, "Keep only this many of the longest details"), details)
        ->excludes(threshold);
    put(reverse->add_flag("--unclamped", reverse_.unclamped,
                          "Leave the ends of an open curve as they are (ill-conditioned) instead of clamping them"),
        details);
    CLI::Option* resample = reverse->add_flag_callback(
        "--resample", [this] { reverse_.fit = FitOption::Resample; },
        "Bring the polygon to the nearest possible number of points, at equal steps of chord length");
    CLI::Option* cut = reverse->add_flag_callback(
        "--cut", [this] { reverse_.fit = FitOption::Cut; }, "Drop points from its end until their number is possible");
    cut->excludes(resample);
    for (CLI::Option* fit : {resample, cut}) belongings_[fit] = for_reversal();
}

void CommandReader::add_compose() {
    CLI::App* compose =
        add("compose", with_examples("Put a polygon together again from the pyramid that reverse wrote.",
                                     "compose data/pyramids/leaf.json",
                                     "compose data/pyramids/leaf.json --level 0 -o coarse.json"));
    compose->add_option("PYRAMID", compose_.pyramid, "JSON of format internode-pyramid, or -")->required();
    add_output(compose, compose_.output);
    add_number(compose, "--level", compose_.level, "This level, 0 is the coarse one (default: the finest)");
    add_count(compose, "--max-points", compose_.max_points, "Refuse more points than this (default 100000000)");
    commands_.push_back({compose, [this] { return Request(compose_); }});
}

} // namespace internode::cli
