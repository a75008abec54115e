// SPDX-License-Identifier: MIT

#include "cli/grids/grid.h"

#include "cli/shell/exit_code.h"
#include "cli/intervals/free_form.h"
#include "cli/shell/load.h"
#include "cli/intervals/symbols.h"
#include "internode/io/obj/free_form_input.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

/// One direction while it is being settled.
struct Side {
    char name; ///< 'u' or 'v'
    const GridSideOptions& options;
    const InputPolygon& input;
    std::size_t points; ///< that the grid has along it
};

/// A word before the number of its letters is settled.
struct SaidWord {
    Axiom axiom;
    bool says_ends = false;
    std::string origin; ///< "--word-u", "the grid's word", "the axiom"
};

InputGrid read_grid_file(const PolygonOptions& options) {
    const LoadedText input = load_text(options.place);
    if (is_obj(input)) {
        const FreeFormFile file = load_free_forms(input);
        const FreeForm& element = chosen_element(file, options.element);
        if (!element.v)
            throw failure(ExitCode::Refused, fmt::format("{} is a curve", element_name(file, element)),
                          "a curve has one grammar: subdivide G FILE");
        return free_form_grid(file, element);
    }
    refuse_element(options.element, input);
    ParsedGrid parsed = read_grid_json(input.text, input.source);
    if (!parsed.grid) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return *std::move(parsed.grid);
}

int settled_degree(const Side& side) {
    const auto& said = side.options.degree;
    const auto& given = side.input.degree;
    if (!said && !given)
        throw failure(ExitCode::Usage, fmt::format("no degree along {}", side.name),
                      "give -d DU,DV, or \"degree\" in the grid's JSON");
    if (said && given && static_cast<std::size_t>(*said) != *given)
        throw failure(ExitCode::Refused, fmt::format("degree {} along {} disagrees with \"degree\": {} of {}", *said,
                                                     side.name, *given, side.input.source));
    if (said) return *said;
    if (*given < 1 || *given > max_degree)
        throw failure(ExitCode::Refused, fmt::format("\"degree\": {} along {} of {} is not between 1 and {}", *given,
                                                     side.name, side.input.source, max_degree));
    return static_cast<int>(*given);
}

/// The word that the JSON gives, as an array of names or as a text.
std::optional<SaidWord> file_word(const Side& side, const Alphabet& alphabet) {
    SaidWord said{{}, false, "the grid's word"};
    if (side.input.word_text) {
        ParsedWord word = parse_word(side.input.word_text->text, alphabet, side.input.source + ": \"word\"");
        if (!word.errors.empty()) throw Failure(ExitCode::Refused, to_string(word.errors));
        said.axiom = std::move(word.axiom);
        said.says_ends = word.says_ends;
        return said;
    }
    if (!side.input.word_letters) return std::nullopt;
    std::vector<Diagnostic> errors;
    for (const PlacedText& letter : *side.input.word_letters) {
        const auto symbol = letter.text == "0" ? std::optional(zero_interval) : alphabet.find(letter.text);
        if (symbol)
            said.axiom.word.push_back(*symbol);
        else
            errors.push_back(unknown_symbol(letter, side.input.source, alphabet));
    }
    if (!errors.empty()) throw Failure(ExitCode::Refused, to_string(errors));
    return said;
}

SaidWord settled_word(const Side& side, const IntervalSystem& system) {
    const std::string option = fmt::format("--word-{}", side.name);
    if (!side.options.word.empty()) {
        ParsedWord word = load_word(side.options.word, system.alphabet());
        return {std::move(word.axiom), word.says_ends, option};
    }
    const std::optional<Axiom>& axiom = system.grammar().axiom;
    std::optional<SaidWord> said = file_word(side, system.alphabet());
    if (said && axiom && said->axiom.word != axiom->word)
        throw failure(ExitCode::Refused,
                      fmt::format("along {} the grid's word ({} letters) and the grammar's axiom ({} letters) disagree",
                                  side.name, said->axiom.word.size(), axiom->word.size()),
                      fmt::format("say which one is meant with {}", option));
    if (said) return *std::move(said);
    if (axiom) return {*axiom, true, "the axiom"};
    throw failure(ExitCode::Refused,
                  fmt::format("no word for the {} points of {} along {}", side.points, side.input.source, side.name),
                  fmt::format("name the knot intervals, for example {} '{}' --repeat", option,
                              to_string(Word{to_symbol(0)}, system.alphabet())));
}

Ends settled_ends(const Side& side, const SaidWord& word) {
    const bool circular = word.says_ends && word.axiom.ends == Ends::Circular;
    if (side.input.closed && !*side.input.closed && circular)
        throw failure(ExitCode::Refused, fmt::format("along {} {} is circular: `( … )`, but \"closed\" is false in {}",
                                                     side.name, word.origin, side.input.source));
    return side.input.closed.value_or(circular) ? Ends::Circular : Ends::Open;
}

/// The letters that the points need: as they are, or repeated and cut.
Word fitted_word(const Side& side, const SaidWord& said, int degree, Ends ends, bool repeat) {
    const std::size_t needed = side.points + (ends == Ends::Open ? static_cast<std::size_t>(degree) : 0);
    const Word& word = said.axiom.word;
    if (word.size() == needed) return word;
    const std::string what = fmt::format("along {} {} points of degree {} need a word of {} letters, but {} has {}",
                                         side.name, side.points, degree, needed, said.origin, word.size());
    if (!repeat) throw failure(ExitCode::Refused, what, "--repeat repeats the letters to fit the points");
    if (word.size() > needed) throw failure(ExitCode::Refused, what);
    return repeated(word, needed);
}

Failure refused(const std::string& source, const std::string& along, const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : problems)
        text += fmt::format("{}: error: {}{}\n", printable(source), along, printable(problem));
    return {ExitCode::Refused, text};
}

/// Knots that the file says leave nothing to say on the command line.
Knots knots_of_file(const Side& side, const IntervalSystem& system, int degree) {
    if (!side.options.word.empty())
        throw failure(ExitCode::Refused, fmt::format("the knots of {} along {} leave nothing to --word-{}",
                                                     side.input.source, side.name, side.name));
    const std::string along = fmt::format("along {}: ", side.name);
    const Ends ends = side.input.closed.value_or(false) ? Ends::Circular : Ends::Open;
    KnotWord said = word_of_knots(system, side.input, side.points, degree, ends, along);
    CheckedKnots checked = make_knots(said.system, {degree, ends, std::move(said.word)});
    if (!checked.knots) throw refused(side.input.source, along, checked.problems);
    return *std::move(checked.knots);
}

Knots load_knots(const Side& side, bool repeat) {
    const IntervalSystem system = fixed_lengths(load_system({side.options.grammar, std::nullopt}), side.input);
    const int degree = settled_degree(side);
    if (side.input.knots) return knots_of_file(side, system, degree);
    const SaidWord said = settled_word(side, system);
    const Ends ends = settled_ends(side, said);
    CheckedKnots checked = make_knots(system, {degree, ends, fitted_word(side, said, degree, ends, repeat)});
    if (!checked.knots) throw refused(side.input.source, fmt::format("along {}: ", side.name), checked.problems);
    return *std::move(checked.knots);
}

/// An option that grids have not, or an empty name.
std::string curve_option(const SubdivideOptions& options) {
    if (options.grammar.expression) return "-e";
    if (!options.polygon.word.empty()) return "--word";
    if (options.polygon.ends != EndsOption::Unsaid) return "the ends of a curve";
    if (options.polygon.rational) return "--rational";
    if (options.derivatives) return "--derivatives";
    return options.axes.empty() ? std::string() : "--axes";
}

/// An option that only grids have, or an empty name.
std::string grid_option(const SubdivideOptions& options) {
    const auto& [u, v] = options.sides;
    if (!u.word.empty() || !v.word.empty()) return "--word-u and --word-v";
    if (u.degree != v.degree) return "two degrees";
    return options.normals ? "--normals" : std::string();
}

} // namespace

void settle_grid_options(SubdivideOptions& options) {
    const auto& [u, v] = options.sides;
    if (!options.is_grid()) {
        if (const std::string name = grid_option(options); !name.empty())
            throw failure(ExitCode::Usage, fmt::format("only a grid has {}", name), "give their grammars: --u G --v G");
        return;
    }
    if (u.grammar.empty() || v.grammar.empty())
        throw failure(ExitCode::Usage, fmt::format("no grammar along {}", u.grammar.empty() ? 'u' : 'v'),
                      "a grid needs both --u and --v");
    if (const std::string name = curve_option(options); !name.empty())
        throw failure(ExitCode::Usage, fmt::format("{} cannot stand beside --u and --v", name),
                      "words are --word-u and --word-v, ends and weights stand in the grid's JSON");
    if (options.grammar.place.empty() || !options.polygon.place.empty())
        throw failure(ExitCode::Usage, options.grammar.place.empty() ? "no grid" : "a second grid",
                      "beside --u and --v give one JSON file, or - for stdin");
    std::swap(options.grammar.place, options.polygon.place);
    if ((u.grammar == "-") + (v.grammar == "-") + (options.polygon.place == "-") > 1)
        throw failure(ExitCode::Usage, "grammars and grid cannot come from stdin together");
}

LoadedGrid load_grid(const SubdivideOptions& options) {
    InputGrid input = read_grid_file(options.polygon);
    const bool repeat = options.polygon.repeat;
    GridData data{load_knots({'u', options.sides[0], input.sides[0], input.rows}, repeat),
                  load_knots({'v', options.sides[1], input.sides[1], input.columns}, repeat), input.dimension,
                  input.rational, std::move(input.points)};
    CheckedGrid checked = make_grid(std::move(data));
    if (!checked.grid) throw refused(input.source, {}, checked.problems);
    return {*std::move(checked.grid), input.source};
}

} // namespace internode::cli
