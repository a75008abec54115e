// SPDX-License-Identifier: MIT
//
// What a user asked for, as values: one aggregate per command, filled by cli/arguments/ and by nothing else.

#pragma once

#include "cli/requests/belonging.h"
#include "internode/input/settled_contour.h"
#include "internode/stencil/plan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace internode::cli {

/// Words that `masks` tabulates at most.
inline constexpr std::size_t max_table_words = 200'000;

/// Letters that the rules of an automaton of several steps may have together: a row of weights each, for every window.
inline constexpr std::uint64_t max_fused_letters = 10'000;

/// Levels that `reverse` goes down: beyond, a word that does not grow would be taken apart for ever.
inline constexpr std::uint64_t max_levels = 100'000;

/// Points of the polygon whose matrix `masks` writes for a point grammar: a matrix of exact numbers.
inline constexpr std::uint64_t max_matrix_points = 100'000;

/// Cycles of a point grammar: a word that does not grow would never end them.
inline constexpr std::uint64_t max_cycles = 100'000;

enum class Color { Auto, Always, Never };

/// Said before or after any command.
struct CommonOptions {
    Color color = Color::Auto;
    bool quiet = false;
    bool verbose = false;
    ApplyOptions apply{.threads = 0}; ///< --threads, and what INTERNODE_ISA and INTERNODE_STORES say
    std::string command_line;         ///< base names, no -o: stands in the outputs
    std::vector<GivenOption> given;   ///< the options on the command line, with where they belong
};

/// What a command needs of its surroundings.
using Context = CommonOptions;

/// A file, `@name`, `-` for stdin, or the text given with -e.
struct GrammarSource {
    std::string place;                     ///< empty when `expression` is given
    std::optional<std::string> expression; ///< -e TEXT
};

/// -o FILE and --format; the format is empty when neither says it.
struct OutputTarget {
    std::string file = "-";
    std::string format;
};

struct ValidateOptions {
    GrammarSource grammar;
    OutputTarget output;
    std::vector<std::string> settings; ///< --set NAME=VALUE, of a point grammar
};

struct MasksOptions {
    GrammarSource grammar;
    OutputTarget output;
    int degree = 0;
    bool all = false;
    bool automaton = false;
    std::uint64_t steps = 1; ///< steps that an automaton takes at once
    std::string word;        ///< the word of --matrix or of an automaton; empty = the axiom, if there is one
    std::optional<std::uint64_t> points; ///< points of the polygon whose matrix a point grammar gives
    std::vector<std::string> settings;   ///< --set NAME=VALUE, of a point grammar
};

/// How the word of a polygon is said on the command line.
using EndsOption = EndsChoice;

struct PolygonOptions {
    std::string place;                    ///< CSV, JSON or OBJ file, `-` for stdin
    std::optional<std::uint64_t> element; ///< --element: which polygon or surface of a file that has several, from 1
    std::optional<int> degree;
    std::string word; ///< --word; empty = the JSON's, or the axiom
    bool repeat = false;
    EndsOption ends = EndsOption::Unsaid;
    bool rational = false; ///< --rational: the last coordinate is the weight
    std::uint64_t max_points = 100'000'000;
    int threads = 0; ///< that read the file; 0: all
};

/// One direction of a grid.
struct GridSideOptions {
    std::string grammar; ///< file, `@name`, `-`; empty = a curve is meant
    std::optional<int> degree;
    std::string word; ///< empty = the JSON's, or the axiom
};

/// What only a point grammar has.
struct PointOptions {
    std::vector<std::string> settings; ///< --set NAME=VALUE
    std::vector<std::string> queries;  ///< --query NAME=V,V
    std::optional<std::uint64_t> phase;
    std::optional<std::uint64_t> seed;
    std::optional<std::uint64_t> max_modules;
    bool trace = false;       ///< the word after every step, as text
    bool tree = false;        ///< the derivation tree, as SVG
    bool interpreter = false; ///< never the compiled automaton
};

/// A curve, or with --u and --v a grid: `polygon` then says its file, repetition and limit alone.
struct SubdivideOptions {
    GrammarSource grammar;
    PolygonOptions polygon;
    OutputTarget output;
    std::uint64_t steps = 0;
    bool limit = false;
    bool derivatives = false; ///< derivatives are written with the limit
    bool plan = false;
    std::string axes;                     ///< "1,2" of --axes; empty = the first two
    std::array<GridSideOptions, 2> sides; ///< u and v
    bool normals = false;                 ///< normals of a grid are written with the limit
    PointOptions point;

    [[nodiscard]] bool is_grid() const { return !sides[0].grammar.empty() || !sides[1].grammar.empty(); }
};

struct ConvergeOptions {
    GrammarSource grammar;
    PolygonOptions polygon;
    OutputTarget output;
    std::uint64_t steps = 0;
    std::optional<double> tolerance;
    std::string html; ///< a file for the page; empty = none
};

/// What may be done to a polygon whose number of points is not possible.
using FitOption = FitChoice;

struct ReverseOptions {
    GrammarSource grammar;
    PolygonOptions polygon; ///< its word is that of the coarse polygon
    OutputTarget output;
    std::optional<std::uint64_t> levels;
    bool local = false;
    std::optional<std::uint64_t> window; ///< intervals of a local filter; fine points of a reverse rule
    std::optional<double> threshold;
    std::optional<std::uint64_t> keep;
    FitOption fit = FitOption::Refuse;
    bool unclamped = false;             ///< open ends stay as they are
    std::string coarse;                 ///< a file for the coarse polygon; empty = none
    std::string picture;                ///< a file for the picture of all levels; empty = none
    std::optional<std::uint64_t> phase; ///< where a point grammar's partition of the ring begins
    bool rules = false;                 ///< the reverse rules of a point grammar alone
    std::vector<std::string> settings;  ///< --set NAME=VALUE, of a point grammar
};

struct InferOptions {
    std::string matrix; ///< CSV of fractions or MatrixMarket, `-` for stdin
    OutputTarget output;
    std::optional<std::int64_t> shift; ///< none: the recommended one
    bool open = false;
    bool long_form = false; ///< the rules of an open curve are to need no order
    std::string name;       ///< the name of the grammar; empty = that of the file
};

struct ComposeOptions {
    std::string pyramid; ///< a file of format "internode-pyramid", `-` for stdin
    OutputTarget output;
    std::optional<std::uint64_t> level; ///< which polygon; the fine one when not said
    std::uint64_t max_points = 100'000'000;
};

struct WordOptions {
    GrammarSource grammar;
    OutputTarget output;
    std::string word;
    std::uint64_t steps = 0;
    std::uint64_t max_letters = 10'000'000;
};

struct FormatOptions {
    GrammarSource grammar;
    OutputTarget output;
};

struct GrammarsOptions {
    std::string name; ///< empty = the list
};

struct MeshOptions {
    std::string file; ///< OBJ, OFF, PLY or STL, `-` for stdin
    OutputTarget output;
    bool repair = false; ///< the mesh is written, made one; else what it is
};

/// `internode formats`: the table itself.
struct FormatsOptions {
    OutputTarget output;
};

struct LimitsOptions {};
struct VersionOptions {};

/// Help was asked for: the text to print.
struct HelpRequest {
    std::string text;
};

using Request = std::variant<ValidateOptions, MasksOptions, SubdivideOptions, ConvergeOptions, ReverseOptions,
                             InferOptions, ComposeOptions, WordOptions, FormatOptions, MeshOptions, FormatsOptions,
                             GrammarsOptions, LimitsOptions, VersionOptions, HelpRequest>;

} // namespace internode::cli
