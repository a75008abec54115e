// SPDX-License-Identifier: MIT

#include "cli/points/points.h"

#include "cli/intervals/polygon.h"
#include "cli/points/point_system.h"
#include "cli/shell/settled.h"
#include "internode/algebra/rational.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/point/start_word.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace internode::cli {

namespace {

/// The two sides of NAME=VALUE.
struct Assignment {
    std::string name;
    std::string value;
};

Assignment assignment(const std::string& option, const std::string& text, const std::string& example) {
    const auto at = text.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == text.size())
        throw failure(ExitCode::Usage, fmt::format("{} wants NAME=VALUE, not `{}`", option, text),
                      fmt::format("like {} {}", option, example));
    return {text.substr(0, at), text.substr(at + 1)};
}

Rational exact_number(const std::string& option, const std::string& text) {
    if (const std::optional<Rational> number = parse_rational(text)) return *number;
    throw failure(ExitCode::Usage, fmt::format("{}: `{}` is no number", option, text),
                  "a decimal or a fraction: 0.25, 1/4");
}

[[noreturn]] void throw_unknown(const std::string& option, const std::string& thing, const std::string& name,
                                const std::vector<std::string>& names) {
    const std::string meant = did_you_mean(name, names);
    std::string hint = "it has none";
    if (!names.empty()) hint = fmt::format("it has {}", fmt::join(names, ", "));
    if (!meant.empty()) hint = fmt::format("did you mean `{}`?", meant);
    throw failure(ExitCode::Usage, fmt::format("{}: the grammar has no {} `{}`", option, thing, name), hint);
}

std::vector<double> numbers(const std::string& text) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        values.push_back(to_double(exact_number("--query", text.substr(begin, end - begin))));
        if (!std::isfinite(values.back()))
            throw failure(ExitCode::Usage, "--query: a number beyond the range of double");
        begin = end + 1;
    }
    return values;
}

/// The query modules of a grammar, without `?`.
std::vector<std::string> query_names(const PointGrammar& grammar) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < grammar.letters.size(); ++i) {
        const std::string name(letter_text(grammar, to_symbol(i)));
        if (name.front() == '?' && std::ranges::find(names, name.substr(1)) == names.end())
            names.push_back(name.substr(1));
    }
    return names;
}

/// What one --query says: the module with as many numbers, and the numbers.
std::pair<Symbol, std::vector<double>> answer(const PointSystem& system, const std::string& query) {
    const Assignment said = assignment("--query", query, "C=1/4");
    const std::vector<std::string> names = query_names(system.grammar());
    if (std::ranges::find(names, said.name) == names.end()) throw_unknown("--query", "query module", said.name, names);
    std::vector<double> values = numbers(said.value);
    const auto letter = find_letter(system.grammar(), "?" + said.name, values.size());
    const std::optional<std::vector<Extent>> layout = letter ? system.layout()[to_index(*letter)] : std::nullopt;
    const bool fits = letter && (!layout || std::ranges::all_of(*layout, [](Extent extent) { return extent == 0; }));
    if (!fits)
        throw failure(ExitCode::Usage, fmt::format("--query {}: no ?{} has {} number{}", query, said.name,
                                                   values.size(), values.size() == 1 ? "" : "s"));
    return {*letter, std::move(values)};
}

/// --query as an environment that answers every module of a letter alike.
Query environment(const PointSystem& system, const std::vector<std::string>& queries) {
    if (queries.empty()) return {};
    std::map<Symbol, std::vector<double>> answers;
    for (const std::string& query : queries)
        if (!answers.insert(answer(system, query)).second)
            throw failure(ExitCode::Usage, fmt::format("--query {} stands twice", query));
    return [answers](const ModuleWord& word, std::size_t position, std::span<double> values) {
        const auto found = answers.find(word.letter(position));
        if (found == answers.end()) return false;
        std::ranges::copy(found->second, values.begin());
        return true;
    };
}

/// Of --max-modules: no memory has room for more, and counts stay far from their largest number.
constexpr std::uint64_t most_modules = 1'000'000'000'000;

DeriveOptions derive_options(const PointSystem& system, const PointOptions& options) {
    DeriveOptions derive;
    derive.max_modules = std::min(options.max_modules.value_or(derive.max_modules), most_modules);
    derive.phase = options.phase.value_or(0);
    derive.seed = options.seed.value_or(0);
    derive.query = environment(system, options.queries);
    return derive;
}

/// What is wrong with a polygon, at its line where it is one of several.
Failure refused(const InputPolygon& polygon, std::string message, std::string hint = {}) {
    Diagnostic diagnostic;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    return failure(placed({{std::move(diagnostic)}, false}, polygon));
}

void check_ends(const InputPolygon& polygon, bool ring) {
    if (polygon.closed && *polygon.closed != ring)
        throw refused(polygon, fmt::format("\"closed\": {} of {}, but the grammar's words are {}", *polygon.closed,
                                           polygon.source, ring ? "rings" : "open"));
    if (ring) refuse_repeated_point(polygon);
}

/// \throw Failure (Refused) for numbers that the input makes infinite
ModuleWord word_of_polygon(const PointSystem& system, const InputPolygon& polygon) {
    try {
        return input_word(system, polygon.points);
    } catch (const std::invalid_argument& problem) {
        throw refused(polygon, fmt::format("{}: {}", polygon.source, problem.what()),
                      "`input` says what each point of a polygon becomes");
    }
}

/// Makes the systems of a grammar for polygons of any dimension, each once.
class Systems {
public:
    Systems(const PointGrammar& grammar, const LoadedText& text, const SubdivideOptions& options)
        : grammar_(grammar)
        , text_(text)
        , constants_(constant_values(grammar, options.point.settings)) {}

    std::shared_ptr<const PointSystem> of(PointStart start, std::size_t dimension) {
        std::shared_ptr<const PointSystem>& system = made_[dimension];
        if (!system)
            system = std::make_shared<PointSystem>(
                checked_system(text_, grammar_, {.dimension = dimension, .constants = constants_, .start = start}));
        return system;
    }

private:
    const PointGrammar& grammar_;
    const LoadedText& text_;
    std::map<std::string, Rational> constants_;
    std::map<std::size_t, std::shared_ptr<const PointSystem>> made_;
};

/// What every start has.
LoadedPoints begun(std::shared_ptr<const PointSystem> system, ModuleWord word, const LoadedText& text,
                   const SubdivideOptions& options) {
    DeriveOptions derive = derive_options(*system, options.point);
    return {.text = text,
            .system = std::move(system),
            .word = std::move(word),
            .derive = std::move(derive),
            .name = {},
            .start = {},
            .columns = {}};
}

LoadedPoints from_axiom(Systems& systems, const LoadedText& text, const SubdivideOptions& options) {
    const std::shared_ptr<const PointSystem> system = systems.of(PointStart::Axiom, PointSettings().dimension);
    LoadedPoints loaded = begun(system, axiom_word(*system), text, options);
    loaded.start = "the axiom";
    return loaded;
}

LoadedPoints from_polygon(Systems& systems, InputPolygon polygon, const LoadedText& text,
                          const SubdivideOptions& options) {
    const std::size_t size = polygon.size();
    const bool has_weights = !polygon.weights.empty();
    if (has_weights) {
        polygon.points = homogeneous(polygon.points, polygon.dimension, polygon.weights);
        ++polygon.dimension;
    }
    const std::shared_ptr<const PointSystem> system = systems.of(PointStart::Input, polygon.dimension);
    LoadedPoints loaded = begun(system, word_of_polygon(*system, polygon), text, options);
    loaded.start = base_name(polygon.source);
    loaded.polygon_size = size;
    loaded.columns = std::move(polygon.columns);
    if (has_weights) loaded.coordinates = Coordinates::Homogeneous;
    loaded.break_text = std::move(polygon.break_text);
    return loaded;
}

} // namespace

std::map<std::string, Rational> constant_values(const PointGrammar& grammar, const std::vector<std::string>& settings) {
    std::vector<std::string> names;
    for (const Definition& definition : grammar.definitions)
        if (definition.formals.empty()) names.push_back(definition.name);
    std::map<std::string, Rational> values;
    for (const std::string& setting : settings) {
        const Assignment said = assignment("--set", setting, "w=1/8");
        if (std::ranges::find(names, said.name) == names.end()) throw_unknown("--set", "constant", said.name, names);
        if (!values.emplace(said.name, exact_number("--set", said.value)).second)
            throw failure(ExitCode::Usage, fmt::format("--set {} stands twice", said.name));
    }
    return values;
}

std::vector<LoadedPoints> load_points(const PointGrammar& grammar, const LoadedText& text,
                                      const SubdivideOptions& options) {
    const bool from_file = !options.polygon.place.empty();
    if (!from_file && !grammar.axiom)
        throw failure(ExitCode::Usage, "no control polygon, and the grammar has no axiom",
                      "give a CSV, JSON or OBJ file, or - for stdin");
    Systems systems(grammar, text, options);
    std::vector<LoadedPoints> parts;
    if (!from_file) parts.push_back(from_axiom(systems, text, options));
    std::vector<InputPolygon> polygons = from_file ? load_polygons(options.polygon) : std::vector<InputPolygon>();
    for (const InputPolygon& polygon : polygons) check_ends(polygon, grammar.ring);
    for (InputPolygon& polygon : polygons) parts.push_back(from_polygon(systems, std::move(polygon), text, options));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].name = display_name(grammar.name, options.grammar);
        parts[i].part = parts.size() > 1 ? i + 1 : 0;
    }
    return parts;
}

StartWord start_of(const LoadedPoints& loaded) {
    if (loaded.system->start() != PointStart::Input) return {};
    return {loaded.polygon_size};
}

Failure derivation_failure(const LoadedPoints& loaded, const DerivationProblem& problem) {
    std::string hint = problem.hint;
    if (loaded.part > 0)
        hint += fmt::format("{}this is part {} of {}", hint.empty() ? "" : "; ", loaded.part, loaded.start);
    return {ExitCode::Refused, to_string(diagnostic_of(loaded.text, problem.place, problem.message, hint))};
}

} // namespace internode::cli
