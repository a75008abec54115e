// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "internode/curve/curve.h"

namespace internode::cli {

void CommandReader::add_grammar_commands() {
    CLI::App* validate =
        add("validate",
            with_examples("Decide, exactly, whether a grammar is a valid interval subdivision descriptor:\n"
                          "verdict, ratio, lengths, frequencies, classes, reasons. Of a point grammar: whether its\n"
                          "points are affine combinations, ends, mask, symbol, degrees, known schemes, smoothness.\n"
                          "Exit 1 when it is not valid.",
                          "validate @fibonacci", "validate @four-point --json"));
    add_grammar(validate, validate_.grammar, false);
    add_output(validate, validate_.output, {"text", "json"});
    add_settings(validate, validate_.settings);
    commands_.push_back({validate, [this] { return Request(validate_); }});

    CLI::App* masks =
        add("masks", with_examples("Exact masks, window stencils and the decomposition graph of a degree.\n"
                                   "With an axiom: the words reachable from it; without: the persistent words.\n"
                                   "Of a point grammar: its mask, and the matrix of one cycle (CSV: exact fractions).",
                                   "masks @fibonacci -d 2", "masks @fibonacci -d 3 --json -o masks.json"));
    add_grammar(masks, masks_.grammar, false);
    add_output(masks, masks_.output, {"text", "json", "mtx", "dot", "svg", "c", "glsl", "csv"});
    masks->add_option("-d,--degree", masks_.degree, "Degree of the B-spline, 1 to 12 (interval grammars need it)")
        ->check(CLI::Range(1, max_degree));
    masks
        ->add_option_function<std::string>(
            "--points", [this](const std::string& text) { masks_.points = whole_number(text); },
            "A point grammar: points of the polygon of the matrix (default 8)")
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
    add_settings(masks, masks_.settings);
    masks->add_flag("--all", masks_.all, "All n^(d+1) words");
    masks->add_option("--word", masks_.word, "With --matrix, --automaton, c, glsl: the word (default: the axiom)")
        ->check(CLI::Validator(empty_word_problem, ""));
    masks->add_flag("--automaton", masks_.automaton,
                    "The stencil automaton as JSON; c (.h) and glsl are its tables as code");
    add_count(masks, "-n,--steps", masks_.steps,
              "With --automaton, c, glsl of interval grammars: so many steps at once (default 1)");
    masks->add_flag_callback(
        "--matrix", [this] { masks_.output.format = "mtx"; }, "The matrix of one step of a word (MatrixMarket)");
    masks->add_flag_callback(
        "--dot", [this] { masks_.output.format = "dot"; }, "The decomposition graph for Graphviz");
    masks->add_flag_callback(
        "--svg", [this] { masks_.output.format = "svg"; }, "The decomposition graph on a circle, up to 64 words");
    commands_.push_back({masks, [this] { return Request(masks_); }});
}

void CommandReader::add_small_commands() {
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

} // namespace internode::cli
