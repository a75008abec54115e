// SPDX-License-Identifier: MIT
//
// The commands that refine: `subdivide` for all kinds, `converge` for curves.

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "cli/arguments/settlement.h"
#include "internode/text/number.h"

namespace internode::cli {
namespace {

/// Stands among the given options when there is a polygon, by whichever place it came.
constexpr const char* a_polygon = "a polygon";

/// A polygon of `subdivide`: what curves, grids and point grammars have of it.
PolygonBelongings belongings_of_subdivide() {
    const Place points_with_polygon{.kinds = {Kind::Points}, .with = {a_polygon}};
    PolygonBelongings all;
    all.word = for_curves(rules_say_everything(), "--word");
    all.ends = for_curves("a point grammar says `ring` itself", "the ends of a curve");
    all.repeat = for_intervals(rules_say_everything());
    all.repeat.places.push_back({.kinds = {Kind::Grids}});
    all.degree = all.repeat;
    all.degree.called = "-d";
    all.max_points = all.repeat;
    all.max_points.refusals.front().hint = "--max-modules is the limit of a point grammar";
    all.weights = for_curves({}, "--rational");
    all.weights.refusals.erase(all.weights.refusals.begin());
    all.weights.places.push_back(points_with_polygon);
    all.element = {.places = {{.kinds = {Kind::Intervals, Kind::Grids}}, points_with_polygon}};
    return all;
}

} // namespace

void CommandReader::add_subdivide() {
    CLI::App* subdivide =
        add("subdivide",
            with_examples("Refine a control polygon or, with --u and --v, a grid: the same curve or surface\n"
                          "over more and more intervals; or rewrite a polygon by a point grammar.",
                          "subdivide @fibonacci data/curves/iceland-coast.csv -d 3 -n 4 --closed --word LS --repeat "
                          "-o coast.svg",
                          "subdivide --u @fibonacci --v @silver-mean data/grids/wave.json -n 3 -o wave.ply"));
    CLI::Option* expression = add_grammar(subdivide, subdivide_.grammar, true);
    belongings_[expression].places = {{.kinds = {Kind::Intervals, Kind::Points}}};
    belongings_[expression].refusals = for_curves({}, "-e").refusals;
    add_output(subdivide, subdivide_.output);
    add_format_flag(subdivide, subdivide_.output, "--svg", "svg", "Same as --format svg");
    add_steps(subdivide, subdivide_.steps, "Steps of subdivision; cycles of a point grammar");
    subdivide->add_flag("--plan", subdivide_.plan, "Say points, bytes, memory and states, and stop");
    add_quiet(subdivide);
    const PolygonBelongings belongings = belongings_of_subdivide();
    put(add_degree(subdivide, 2,
                   [this](const std::vector<int>& said) {
                       subdivide_.polygon.degree = said.front();
                       subdivide_.sides[0].degree = said.front();
                       subdivide_.sides[1].degree = said.back();
                   }),
        belongings.degree);
    add_polygon(subdivide, subdivide_.polygon, belongings);
    add_limit(subdivide);
    add_drawing(subdivide);
    add_grid(subdivide);
    add_point(subdivide);
    commands_.push_back({subdivide, [this] {
                             settle(subdivide_);
                             if (!subdivide_.polygon.place.empty()) common_.given.push_back({a_polygon, {}});
                             return Request(subdivide_);
                         }});
}

/// The curve or surface itself, instead of the polygon.
void CommandReader::add_limit(CLI::App* subdivide) {
    Belonging limit = for_intervals(rules_say_everything());
    limit.places.front().formats = {"csv", "npy", "obj"};
    limit.places.push_back({.kinds = {Kind::Grids}, .formats = {"obj", "ply", "stl"}});
    const std::string hint = "use CSV, NPY or OBJ; SVG always draws the curve";
    limit.refusals.push_back({.kinds = {Kind::Intervals},
                              .format = "json",
                              .message = "points of the curve have no word: --limit has no JSON form",
                              .hint = hint});
    limit.refusals.push_back({.kinds = {Kind::Intervals}, .format = "svg", .hint = hint});
    limit.refusals.push_back({.kinds = {Kind::Grids},
                              .format = "json",
                              .message = "points of the surface have no word: --limit has no JSON form",
                              .hint = "use OBJ, PLY or STL"});
    Belonging derivatives = for_curves(rules_say_everything(), "--derivatives");
    derivatives.places.front().with = {"--limit"};
    derivatives.places.front().formats = {"csv", "npy"};
    put(subdivide->add_flag("--derivatives", subdivide_.derivatives,
                            "With --limit: two derivatives, tangent and curvature too"),
        derivatives);
    put(subdivide->add_flag("--limit", subdivide_.limit, "The curve or surface itself at the distinct knots"), limit);
}

/// What is drawn, what is said, and how fast.
void CommandReader::add_drawing(CLI::App* subdivide) {
    Belonging axes = for_curves({}, "--axes");
    axes.places = {{.kinds = {Kind::Intervals}, .formats = {"svg"}},
                   {.kinds = {Kind::Points}, .formats = {"svg"}, .without = {"--tree"}}};
    axes.refusals.erase(axes.refusals.begin());
    put(subdivide->add_option("--axes", subdivide_.axes, "Coordinates drawn in SVG: i,j counted from 1"), axes);
    const Belonging compiled{.places = {{.kinds = {Kind::Intervals, Kind::Grids}},
                                        {.kinds = {Kind::Points},
                                         .formats = {"csv", "json", "npy", "obj", "text"},
                                         .without = {"--trace", "--tree", "--interpreter"}}}};
    belongings_[add_verbose(subdivide)] = compiled;
    belongings_[add_count(subdivide, "--threads", threads_,
                          "Threads, 0 for all (default); they change no byte of the result")] = compiled;
}

void CommandReader::add_grid(CLI::App* subdivide) {
    auto& [u, v] = subdivide_.sides;
    const Belonging words = for_grids("--word-u and --word-v");
    put(subdivide->add_option("--u", u.grammar, "The grammar along u, the rows; beside it one JSON file (-d DU,DV)"),
        for_grids("--u and --v"));
    put(subdivide->add_option("--v", v.grammar, "The grammar along v, within a row"), for_grids("--u and --v"));
    put(add_word(subdivide, "--word-u", u.word, "--word for this direction"), words);
    put(add_word(subdivide, "--word-v", v.word, "--word for this direction"), words);
    Belonging normals = for_grids("--normals");
    normals.places.front().with = {"--limit"};
    normals.places.front().formats = {"obj", "ply"};
    normals.refusals.insert(normals.refusals.begin(),
                            {.kinds = {Kind::Grids},
                             .message = "--normals belongs to --limit: control points have none",
                             .hint = "add --limit"});
    put(subdivide->add_flag("--normals", subdivide_.normals, "With --limit: unit normals too (OBJ, PLY)"), normals);
}

void CommandReader::add_converge() {
    CLI::App* converge = add(
        "converge", with_examples("How fast the control polygons approach the curve: errors, ratios, exact constant,\n"
                                  "guaranteed envelope, steps for a tolerance, comparison with uniform bisection.",
                                  "converge @fibonacci data/curves/fibonacci-open.json -n 8",
                                  "converge @fibonacci data/curves/fibonacci-open.json -n 6 --html report.html"));
    add_grammar(converge, converge_.grammar, true);
    add_output(converge, converge_.output);
    add_steps(converge, converge_.steps, "Steps of subdivision");
    add_degree(converge, 1, [this](const std::vector<int>& said) { converge_.polygon.degree = said.front(); });
    add_polygon(converge, converge_.polygon, {});
    converge
        ->add_option_function<std::string>(
            "--tolerance", [this](const std::string& text) { converge_.tolerance = parse_double(text); },
            "How many steps until the envelope is below this")
        ->check(CLI::Validator(positive_number, ""));
    converge->add_option("--html", converge_.html, "Write the report as one self-contained page");
    commands_.push_back({converge, [this] {
                             settle(converge_);
                             return Request(converge_);
                         }});
}

} // namespace internode::cli
