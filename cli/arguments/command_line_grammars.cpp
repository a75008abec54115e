// SPDX-License-Identifier: MIT
//
// The commands that ask about a grammar, and the lists of what there is.

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "cli/arguments/settlement.h"
#include "internode/curve/knots.h"

namespace internode::cli {

void CommandReader::add_validate() {
    CLI::App* validate =
        add("validate",
            with_examples("Decide, exactly, whether a grammar is a valid interval subdivision descriptor:\n"
                          "verdict, ratio, lengths, frequencies, classes, reasons. Of a point grammar: whether its\n"
                          "points are affine combinations, ends, mask, symbol, degrees, known schemes, smoothness.\n"
                          "Exit 1 when it is not valid.",
                          "validate @fibonacci", "validate @four-point --json"));
    add_grammar(validate, validate_.grammar, false);
    add_output(validate, validate_.output);
    put(add_settings(validate, validate_.settings), for_points());
    commands_.push_back({validate, [this] {
                             settle(validate_);
                             return Request(validate_);
                         }});
}

void CommandReader::add_masks() {
    const std::string points_hint = "--points says the number of points of the matrix";
    CLI::App* masks =
        add("masks", with_examples("Exact masks, window stencils and the decomposition graph of a degree.\n"
                                   "With an axiom: the words reachable from it; without: the persistent words.\n"
                                   "Of a point grammar: its mask, and the matrix of one cycle (CSV: exact fractions).",
                                   "masks @fibonacci -d 2", "masks @fibonacci -d 3 --json -o masks.json"));
    add_grammar(masks, masks_.grammar, false);
    add_output(masks, masks_.output);
    add_mask_pictures(masks);
    Belonging degree = for_intervals(points_hint);
    degree.called = "-d";
    put(masks->add_option("-d,--degree", masks_.degree, "Degree of the B-spline, 1 to 12 (needed)")
            ->check(CLI::Range(1, max_degree)),
        degree);
    Belonging all = for_intervals(points_hint);
    all.places = {
        {.kinds = {Kind::Intervals}, .formats = {"text", "json", "dot", "svg", "c", "glsl"}, .without = {"--word"}}};
    put(masks->add_flag("--all", masks_.all, "All n^(d+1) words"), all);
    Belonging word = for_intervals(points_hint);
    word.places = {{.kinds = {Kind::Intervals}, .with = {"--automaton"}},
                   {.kinds = {Kind::Intervals}, .formats = {"mtx", "c", "glsl"}}};
    put(add_word(masks, "--word", masks_.word, "With --matrix, --automaton, c, glsl: the word (default: the axiom)"),
        word);
    Belonging steps = word;
    steps.places.back().formats = {"c", "glsl"};
    steps.refusals.front().message = "-n belongs to interval grammars";
    put(add_count(masks, "-n,--steps", masks_.steps, "With --automaton, c, glsl: so many steps at once (default 1)"),
        steps);
    Belonging of_points = for_points();
    of_points.refusals = {{.hint = "-d says the degree"}};
    put(add_number(masks, "--points", masks_.points, "Points of the polygon of the matrix (default 8)"), of_points);
    put(add_settings(masks, masks_.settings), of_points);
    belongings_[add_verbose(masks)] = {
        .places = {{.kinds = {Kind::Intervals}, .formats = {"text", "json", "c", "glsl"}}}};
    commands_.push_back({masks, [this] {
                             settle(masks_);
                             return Request(masks_);
                         }});
}

/// The automaton, and the formats of masks by flags of their own.
void CommandReader::add_mask_pictures(CLI::App* masks) {
    const Belonging automaton{
        .places = {{.kinds = {Kind::Intervals}, .formats = {"json", "c", "glsl"}}, {.kinds = {Kind::Points}}}};
    CLI::Option* flag = masks->add_flag("--automaton", masks_.automaton,
                                        "The stencil automaton as JSON; c (.h) and glsl are its tables as code");
    belongings_[flag] = automaton;
    add_format_flag(masks, masks_.output, "--matrix", "mtx", "The matrix of one step of a word (MatrixMarket)");
    add_format_flag(masks, masks_.output, "--dot", "dot", "The decomposition graph for Graphviz");
    add_format_flag(masks, masks_.output, "--svg", "svg", "The decomposition graph on a circle, up to 64 words");
}

void CommandReader::add_small_commands() {
    CLI::App* word =
        add("word", with_examples("The rewritten word of the axiom (or --word) and its letter counts.",
                                  "word @fibonacci --word L -n 8", "word @tribonacci --word '(A)' -n 5 --json"));
    add_grammar(word, word_.grammar, false);
    add_output(word, word_.output);
    add_steps(word, word_.steps, "Steps of rewriting");
    add_word(word, "--word", word_.word, "Start from this word instead of the axiom");
    add_count(word, "--max-letters", word_.max_letters, "Refuse a longer word (default 10000000)");
    commands_.push_back({word, [this] {
                             settle(word_);
                             return Request(word_);
                         }});

    CLI::App* format = add("format", with_examples("A grammar in the normal form of the language.",
                                                   "format -e 'L → S L; S → L'", "format @slow-growth-3"));
    add_grammar(format, format_.grammar, false);
    add_output(format, format_.output);
    commands_.push_back({format, [this] {
                             settle(format_);
                             return Request(format_);
                         }});
    add_lists();
}

/// What there is: formats, grammars, limits.
void CommandReader::add_lists() {
    CLI::App* formats = add("formats", with_examples("The formats that the command writes, and which command writes "
                                                     "which for which kind of grammar.",
                                                     "formats", "formats --json"));
    add_output(formats, formats_.output);
    commands_.push_back({formats, [this] { return Request(formats_); }});

    CLI::App* grammars =
        add("grammars", with_examples("The bundled grammars, each usable as @name.", "grammars", "grammars fibonacci"));
    grammars->add_option("NAME", grammars_.name, "Print this grammar");
    commands_.push_back({grammars, [this] { return Request(grammars_); }});

    CLI::App* limits = add(
        "limits", with_examples("Every limit the command keeps, with its number.", "limits", "limits --color never"));
    commands_.push_back({limits, [] { return Request(LimitsOptions{}); }});
}

} // namespace internode::cli
