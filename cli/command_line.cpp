// SPDX-License-Identifier: MIT
//
// CLI11 keeps its own opinion of errors and exit codes; here both become ours: every mistake is exit 2 with one line
// and a hint. Words that no option takes are collected by CLI11 and judged at the end, so that a misspelt option can
// be compared with the ones that exist.

#include "cli/command_line.h"

#include "cli/exit_code.h"
#include "cli/grid.h"
#include "cli/option_checks.h"
#include "cli/places.h"
#include "cli/public_command_line.h"
#include "internode/curve/curve.h"
#include "internode/grammar/diagnostic.h"
#include "internode/io/number.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

namespace internode::cli {
namespace {

std::string with_examples(const std::string& what, const std::string& first, const std::string& second) {
    return fmt::format("{}\n\nExamples:\n  internode {}\n  internode {}\n", what, first, second);
}

/// A command while it is being read: the parser's view, and how to make the request of it.
struct Command {
    CLI::App* app = nullptr;
    std::function<Request()> finish;
};

class Reader {
public:
    Reader();
    CommandLine read(int argc, const char* const* argv);

private:
    CLI::App* add(const std::string& name, const std::string& description);
    void add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon);
    void add_output(CLI::App* app, OutputTarget& output, const std::vector<std::string>& formats);
    void add_polygon(CLI::App* app, PolygonOptions& polygon, std::array<GridSideOptions, 2>* sides);
    void add_grid(CLI::App* app, SubdivideOptions& subdivide);
    static CLI::Option* add_count(CLI::App* app, const std::string& name, std::uint64_t& count,
                                  const std::string& what);
    static void add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what);
    void add_common(CLI::App* app);
    void add_commands();
    void add_curve_commands();
    void add_pyramid_commands();
    void add_small_commands();
    void refuse_leftovers(const CLI::App& app) const;
    [[nodiscard]] std::vector<std::string> known_words(const CLI::App& app) const;

    CLI::App app_{
        with_examples("internode: subdivision described by grammars.", "validate @fibonacci", "masks @fibonacci -d 2"),
        "internode"};
    CommonOptions common_;
    ValidateOptions validate_;
    MasksOptions masks_;
    SubdivideOptions subdivide_;
    ConvergeOptions converge_;
    ReverseOptions reverse_;
    ComposeOptions compose_;
    WordOptions word_;
    FormatOptions format_;
    GrammarsOptions grammars_;
    std::string color_ = "auto";
    std::uint64_t threads_ = 0;
    bool version_ = false;
    std::vector<Command> commands_;
};

Reader::Reader() {
    app_.require_subcommand(0, 1);
    app_.allow_extras();
    app_.set_help_flag("-h,--help", "This text");
    app_.add_flag("--version", version_, "Version, compiler, instruction set, libraries");
    add_common(&app_);
    add_commands();
    add_curve_commands();
    add_pyramid_commands();
    add_small_commands();
}

CLI::App* Reader::add(const std::string& name, const std::string& description) {
    CLI::App* command = app_.add_subcommand(name, description);
    command->allow_extras();
    command->set_help_flag("-h,--help", "This text");
    command->get_formatter()->column_width(34);
    add_common(command);
    return command;
}

void Reader::add_common(CLI::App* app) {
    app->add_flag("-q,--quiet", common_.quiet, "Only errors on stderr");
    app->add_flag("-v,--verbose", common_.verbose, "Say more on stderr");
    app->add_option("--color", color_, "auto, always or never (NO_COLOR counts)")
        ->check(CLI::IsMember({"auto", "always", "never"}));
}

void Reader::add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon) {
    app->add_option("GRAMMAR", grammar.place,
                    with_polygon ? "Grammar file, @name of a bundled one, or - (left out with -e)"
                                 : "Grammar file, @name of a bundled one, or -");
    app->add_option("-e,--expression", grammar.expression, "The grammar itself: -e 'L->SL, S->L'");
}

void Reader::add_output(CLI::App* app, OutputTarget& output, const std::vector<std::string>& formats) {
    app->add_option("-o,--output", output.file, "Output file, - for stdout (default); the extension names the format");
    app->add_option("--format", output.format, fmt::format("{}", fmt::join(formats, ", ")))
        ->check(CLI::IsMember(formats));
    const auto has = [&formats](const char* name) { return std::ranges::find(formats, name) != formats.end(); };
    if (has("json"))
        app->add_flag_callback(
            "--json", [&output] { output.format = "json"; }, "Same as --format json");
}

/// With `sides`, -d takes the two degrees of a grid too.
void Reader::add_polygon(CLI::App* app, PolygonOptions& polygon, std::array<GridSideOptions, 2>* sides) {
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

void Reader::add_grid(CLI::App* app, SubdivideOptions& subdivide) {
    auto& [u, v] = subdivide.sides;
    app->add_option("--u", u.grammar, "A grid: the grammar along u, the rows; beside it one JSON file (-d DU,DV)");
    app->add_option("--v", v.grammar, "A grid: the grammar along v, within a row");
    for (GridSideOptions* side : {&u, &v})
        app->add_option(side == &u ? "--word-u" : "--word-v", side->word, "A grid: --word for this direction")
            ->check(CLI::Validator(empty_word_problem, ""));
    app->add_flag("--normals", subdivide.normals, "A grid, with --limit: unit normals too (OBJ, PLY)");
}

CLI::Option* Reader::add_count(CLI::App* app, const std::string& name, std::uint64_t& count, const std::string& what) {
    const auto read = [&count](const std::string& text) { count = whole_number(text).value_or(0); };
    return app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

void Reader::add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what) {
    add_count(app, "-n,--steps", steps, what)->required();
}

void Reader::add_commands() {
    CLI::App* validate =
        add("validate",
            with_examples("Decide, exactly, whether a grammar is a valid interval subdivision descriptor:\n"
                          "verdict, ratio, lengths, frequencies, classes, reasons. Exit 1 when it is not valid.",
                          "validate @fibonacci", "validate -e 'L->SL, S->L' --json"));
    add_grammar(validate, validate_.grammar, false);
    add_output(validate, validate_.output, {"text", "json"});
    commands_.push_back({validate, [this] { return Request(validate_); }});

    CLI::App* masks =
        add("masks", with_examples("Exact masks, window stencils and the decomposition graph of a degree.\n"
                                   "With an axiom: the words reachable from it; without: the persistent words.",
                                   "masks @fibonacci -d 2", "masks @fibonacci -d 3 --json -o masks.json"));
    add_grammar(masks, masks_.grammar, false);
    add_output(masks, masks_.output, {"text", "json", "mtx", "dot", "svg", "c", "glsl"});
    masks->add_option("-d,--degree", masks_.degree, "Degree of the B-spline, 1 to 12")
        ->required()
        ->check(CLI::Range(1, max_degree));
    masks->add_flag("--all", masks_.all, "All n^(d+1) words");
    masks->add_option("--word", masks_.word, "With --matrix, --automaton, c, glsl: the word (default: the axiom)")
        ->check(CLI::Validator(empty_word_problem, ""));
    masks->add_flag("--automaton", masks_.automaton,
                    "The stencil automaton as JSON; c (.h) and glsl are its tables as code");
    add_count(masks, "-n,--steps", masks_.steps, "With --automaton, c, glsl: so many steps at once (default 1)");
    masks->add_flag_callback(
        "--matrix", [this] { masks_.output.format = "mtx"; }, "The matrix of one step of a word (MatrixMarket)");
    masks->add_flag_callback(
        "--dot", [this] { masks_.output.format = "dot"; }, "The decomposition graph for Graphviz");
    masks->add_flag_callback(
        "--svg", [this] { masks_.output.format = "svg"; }, "The decomposition graph on a circle, up to 64 words");
    commands_.push_back({masks, [this] { return Request(masks_); }});
}

void Reader::add_curve_commands() {
    CLI::App* subdivide =
        add("subdivide",
            with_examples("Refine a control polygon or, with --u and --v, a grid: the same curve or surface\n"
                          "over more and more intervals.",
                          "subdivide @fibonacci data/curves/iceland-coast.csv -d 3 -n 4 --closed --word LS --repeat "
                          "-o coast.svg",
                          "subdivide --u @fibonacci --v @silver-mean data/grids/wave.json -n 3 -o wave.ply"));
    add_grammar(subdivide, subdivide_.grammar, true);
    add_polygon(subdivide, subdivide_.polygon, &subdivide_.sides);
    add_grid(subdivide, subdivide_);
    add_output(subdivide, subdivide_.output, {"csv", "json", "npy", "obj", "svg", "ply", "stl"});
    add_steps(subdivide, subdivide_.steps, "Steps of subdivision");
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

void Reader::add_pyramid_commands() {
    CLI::App* reverse = add(
        "reverse", with_examples("Take a polygon apart: a coarse polygon and the details of every step back to it.\n"
                                 "--word names the intervals of the coarse polygon.",
                                 "reverse @fibonacci data/curves/iceland-coast.csv -d 3 -n 5 --closed --word LSLLS "
                                 "--repeat --resample --picture levels.svg",
                                 "reverse @fibonacci data/curves/leaf.csv -d 2 -n 2 --closed --word LS --repeat "
                                 "--keep 5 -o pyramid.json"));
    add_grammar(reverse, reverse_.grammar, true);
    add_polygon(reverse, reverse_.polygon, nullptr);
    add_output(reverse, reverse_.output, {"text", "json"});
    const auto levels = [this](const std::string& text) { reverse_.levels = whole_number(text); };
    const auto keep = [this](const std::string& text) { reverse_.keep = whole_number(text); };
    const CLI::Validator whole(whole_number_problem, "");
    reverse->add_option_function<std::string>("-n,--levels", levels, "Steps down (default: what the word asks for)")
        ->type_name("N")
        ->check(whole);
    reverse->add_flag_callback(
        "--local", [this] { reverse_.local = true; }, "Local filters instead of least squares");
    add_count(reverse, "--window", reverse_.window, "Intervals of a local filter (default 5)")
        ->check(CLI::Range(1, 64));
    auto* threshold = reverse->add_option_function<std::string>(
        "--threshold", [this](const std::string& text) { reverse_.threshold = parse_double(text); },
        "Keep only details at least this long");
    threshold->check(CLI::Validator(positive_number, ""));
    auto* count =
        reverse->add_option_function<std::string>("--keep", keep, "Keep only this many of the longest details");
    count->type_name("N")->check(whole)->excludes(threshold);
    reverse->add_flag("--unclamped", reverse_.unclamped,
                      "Leave the ends of an open curve as they are (ill-conditioned) instead of clamping them");
    auto* resample = reverse->add_flag_callback(
        "--resample", [this] { reverse_.fit = FitOption::Resample; },
        "Bring the polygon to the nearest possible number of points, at equal steps of chord length");
    auto* cut = reverse->add_flag_callback(
        "--cut", [this] { reverse_.fit = FitOption::Cut; }, "Drop points from its end until their number is possible");
    cut->excludes(resample);
    reverse->add_option("--coarse", reverse_.coarse, "Write the coarse polygon: CSV or JSON by the extension");
    reverse->add_option("--picture", reverse_.picture, "Write a picture of all levels (SVG)");
    commands_.push_back({reverse, [this] { return Request(reverse_); }});

    CLI::App* compose =
        add("compose", with_examples("Put a polygon together again from the pyramid that reverse wrote.",
                                     "compose data/pyramids/leaf.json",
                                     "compose data/pyramids/leaf.json --level 0 -o coarse.json"));
    compose->add_option("PYRAMID", compose_.pyramid, "JSON of format internode-pyramid, or -")->required();
    add_output(compose, compose_.output, {"csv", "json", "npy", "obj"});
    const auto level = [this](const std::string& text) { compose_.level = whole_number(text); };
    compose->add_option_function<std::string>("--level", level, "This level, 0 is the coarse one (default: the finest)")
        ->type_name("N")
        ->check(whole);
    add_count(compose, "--max-points", compose_.max_points, "Refuse more points than this (default 100000000)");
    commands_.push_back({compose, [this] { return Request(compose_); }});
}

void Reader::add_small_commands() {
    CLI::App* word =
        add("word", with_examples("The rewritten word of the axiom (or --word) and its letter counts.",
                                  "word @fibonacci --word L -n 8", "word @tribonacci --word '(A)' -n 5 --json"));
    add_grammar(word, word_.grammar, false);
    add_output(word, word_.output, {"text", "json"});
    add_steps(word, word_.steps, "Steps of rewriting");
    word->add_option("--word", word_.word, "Start from this word instead of the axiom")
        ->check(CLI::Validator(empty_word_problem, ""));
    add_count(word, "--max-letters", word_.max_letters, "Refuse a longer word (default 10000000)");
    commands_.push_back({word, [this] { return Request(word_); }});

    CLI::App* format = add("format", with_examples("A grammar in the normal form of the language.",
                                                   "format -e 'L → S L; S → L'", "format @slow-growth-3"));
    add_grammar(format, format_.grammar, false);
    add_output(format, format_.output, {"text"});
    commands_.push_back({format, [this] { return Request(format_); }});

    CLI::App* grammars =
        add("grammars", with_examples("The bundled grammars, each usable as @name.", "grammars", "grammars fibonacci"));
    grammars->add_option("NAME", grammars_.name, "Print this grammar");
    commands_.push_back({grammars, [this] { return Request(grammars_); }});

    CLI::App* limits =
        add("limits", with_examples("Every limit the command keeps, with its number.", "limits", "limits --quiet"));
    commands_.push_back({limits, [] { return Request(LimitsOptions{}); }});
}

std::vector<std::string> Reader::known_words(const CLI::App& app) const {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
        for (const std::string& name : option->get_snames()) words.push_back("-" + name);
    }
    if (&app == &app_)
        for (const Command& command : commands_) words.push_back(command.app->get_name());
    return words;
}

void Reader::refuse_leftovers(const CLI::App& app) const {
    const std::vector<std::string> left = app.remaining();
    if (left.empty()) return;
    const std::string& word = left.front();
    const bool option = word.size() > 1 && word[0] == '-';
    const std::string kind = option ? "option" : (&app == &app_ ? "command" : "argument");
    const std::string meant = did_you_mean(word, known_words(app));
    const std::string where = &app == &app_ ? "internode --help" : fmt::format("internode {} --help", app.get_name());
    throw failure(ExitCode::Usage, fmt::format("unknown {} `{}`", kind, word),
                  meant.empty() ? fmt::format("see `{}`", where) : fmt::format("did you mean `{}`?", meant));
}

/// More threads than this are as many.
constexpr std::uint64_t max_threads = 1024;

CommandLine Reader::read(int argc, const char* const* argv) {
    try {
        app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = app_.get_subcommands();
        return {common_, HelpRequest{chosen.empty() ? app_.help() : chosen.front()->help("internode")}};
    } catch (const CLI::ParseError& error) {
        throw failure(ExitCode::Usage, error.what());
    }
    if (color_ != "auto") common_.color = color_ == "always" ? Color::Always : Color::Never;
    common_.threads = static_cast<int>(std::min<std::uint64_t>(threads_, max_threads));
    common_.isa = isa_of_environment();
    refuse_leftovers(app_);
    if (version_) return {common_, VersionOptions{}};
    for (const Command& command : commands_) {
        if (!command.app->parsed()) continue;
        refuse_leftovers(*command.app);
        return {common_, command.finish()};
    }
    return {common_, HelpRequest{app_.help()}};
}

} // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
    CommandLine line = Reader().read(argc, argv);
    line.common.command_line = public_command_line(argc, argv);
    std::visit(
        [](auto& options) {
            if constexpr (requires { options.sides; }) {
                settle_grid_options(options);
                if (options.is_grid()) return;
            }
            if constexpr (requires { options.polygon; }) settle_places(options.grammar, options.polygon);
            if constexpr (requires { options.grammar; }) check_grammar(options.grammar);
        },
        line.request);
    return line;
}

} // namespace internode::cli
