// SPDX-License-Identifier: MIT
//
// Any bytes as a file of polygons, each rewritten by a bundled point grammar and written again: refused with a
// sentence, or the automaton gives the interpreter's word, of the length that was foretold, and its drawing is finite
// and is read back from CSV and OBJ as the polygon that it is. The last byte chooses the grammar, the phase and the
// weights.

#include "internode/curve/homogeneous.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/input/plain_polygon.h"
#include "internode/input/polygon_file.h"
#include "internode/io/csv.h"
#include "internode/io/obj/obj.h"
#include "internode/io/obj/obj_polylines.h"
#include "internode/point/compile/fast_derivation.h"
#include "internode/point/growth.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"
#include "internode/report/picture/levels_picture.h"
#include "tests/fuzz/small_inputs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace {

using namespace internode;
using fuzz::require;

constexpr std::uint64_t cycles = 2;
constexpr std::uint64_t most_modules = 2000;

/// Rings and open words, phases and tables, draws, lines of their own, interpretations, points that are turned.
constexpr std::array<std::string_view, 12> grammars{"s0/13", "four-point", "koch",     "midpoint-displacement",
                                                    "s0/38", "s0/34-36",   "s1/10",    "s1/13",
                                                    "s1/17", "s1/20-21",   "s0/28-33", "corner-cutting"};

/// A system for each grammar and dimension that was asked for; none where the grammar is of another dimension.
const std::optional<PointSystem>& system_of(unsigned choice, std::size_t dimension) {
    static std::map<std::pair<unsigned, std::size_t>, std::optional<PointSystem>> made;
    const std::pair<unsigned, std::size_t> key{choice % grammars.size(), dimension};
    const auto known = made.find(key);
    if (known != made.end()) return known->second;
    const BundledGrammar* const bundled = find_bundled_grammar(grammars[key.first]);
    require(bundled != nullptr);
    ParsedPointGrammar parsed = parse_point_grammar(bundled->text, "<fuzz>");
    require(parsed.grammar.has_value());
    CheckedPointSystem checked =
        make_point_system(std::move(*parsed.grammar), {.dimension = dimension, .start = PointStart::Input});
    require(checked.system.has_value() == checked.problems.empty());
    return made.emplace(key, std::move(checked.system)).first->second;
}

/// None where a coordinate is more than a double holds.
std::optional<ModuleWord> word_of(const PointSystem& system, const std::vector<double>& points) {
    try {
        return input_word(system, points);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

double size_of(const ModuleWord& word) {
    double largest = 0;
    for (std::size_t i = 0; i < word.size(); ++i)
        for (const double value : word.values(i)) {
            require(std::isfinite(value));
            largest = std::max(largest, std::abs(value));
        }
    return largest;
}

/// The same letters, and numbers that differ by rounding; `scale` is the size of the numbers they were made of.
void require_alike(const ModuleWord& fast, const ModuleWord& slow, double scale) {
    require(fast.size() == slow.size() && std::ranges::equal(fast.letters(), slow.letters()));
    const double tolerance = 1e-12 * std::max(scale, size_of(slow)) + 1e-300;
    for (std::size_t i = 0; i < fast.size(); ++i) {
        const std::span<const double> some = fast.values(i);
        const std::span<const double> others = slow.values(i);
        require(some.size() == others.size());
        for (std::size_t k = 0; k < some.size(); ++k)
            require(std::isfinite(some[k]) && std::abs(some[k] / 2 - others[k] / 2) <= tolerance);
    }
}

/// Points of a table or of vertices, as they were.
void require_read_back(const ParsedPolygons& parsed, const std::vector<double>& points, std::size_t dimension) {
    require(parsed.polygons.size() == 1);
    const InputPolygon& polygon = parsed.polygons.front();
    for (std::size_t at = 0; at < points.size(); ++at)
        require(polygon.points.at(at / dimension * polygon.dimension + at % dimension) == points[at]);
}

void require_written(const PointStrands& drawing) {
    const PointsView points{drawing.dimension, drawing.points};
    for (const double coordinate : drawing.points) require(std::isfinite(coordinate));
    StringSink table;
    require(write_csv(table, points, {.header = coordinate_names(drawing.dimension)}));
    require_read_back(read_polygons_csv(table.text(), "again.csv"), drawing.points, drawing.dimension);
    if (drawing.dimension > max_obj_dimension || drawing.strands.size() != 1 || drawing.size() < 2) return;
    const PointStrands::Strand& strand = drawing.strands.front();
    StringSink vertices;
    require(write_obj(vertices, points, std::vector<ObjPolyline>{{strand.points, strand.closed}}));
    if (drawing.size() == strand.points.size() && std::ranges::is_sorted(strand.points))
        require_read_back(read_obj_polylines(vertices.text(), "again.obj"), drawing.points, drawing.dimension);
}

/// What the last byte says beside the grammar.
FastOptions options_of(unsigned choice) {
    FastOptions options;
    options.derive.max_modules = most_modules;
    options.derive.max_work = 3'000'000;
    options.derive.seed = choice;
    options.derive.phase = (choice & 64U) != 0 ? 1 : 0;
    return options;
}

/// The drawings of the start and of the end; none where the derivation is refused.
std::optional<std::array<PointStrands, 2>> refined(const PointSystem& system, const ModuleWord& word,
                                                   std::size_t points, unsigned choice) {
    FastOptions options = options_of(choice);
    const FastDerivation fast = derive_fast(system, {word, {points}}, cycles, options);
    options.interpreter_only = true;
    const FastDerivation slow = derive_fast(system, {word, {points}}, cycles, options);
    const bool too_large = fast.too_large.has_value();
    require(fast.word.has_value() == slow.word.has_value() || too_large);
    for (const FastDerivation* const derived : {&fast, &slow})
        if (derived->problem) require(!derived->problem->message.empty());
    if (!fast.word || !slow.word) return std::nullopt;
    require_alike(*fast.word, *slow.word, size_of(word));
    const auto length = predicted_length(system, word, cycles, most_modules);
    require(!length || *length == slow.word->size());
    const std::size_t passes = system.grammar().interpretations.size();
    const Derivation before = interpret(system, word, options.derive);
    const Derivation after = interpret(system, *fast.word, options.derive);
    if (before.problem || after.problem) return std::nullopt;
    return std::array<PointStrands, 2>{strands(before.word, system, passes), strands(after.word, system, passes)};
}

/// The drawings of a polygon, where the grammar takes it.
std::optional<std::array<PointStrands, 2>> drawings_of(InputPolygon polygon, unsigned choice) {
    if ((choice & 128U) != 0) {
        Settled<InputPolygon> weighted = with_weights(std::move(polygon));
        require(weighted.value.has_value() == weighted.refusal.errors.empty());
        if (!weighted.value) return std::nullopt;
        polygon = *std::move(weighted.value);
    }
    const std::size_t size = polygon.size();
    if (!polygon.weights.empty()) {
        polygon.points = homogeneous(polygon.points, polygon.dimension, polygon.weights);
        ++polygon.dimension;
    }
    const std::optional<PointSystem>& system = system_of(choice, polygon.dimension);
    if (!system) return std::nullopt;
    const std::optional<ModuleWord> word = word_of(*system, polygon.points);
    return word ? refined(*system, *word, size, choice) : std::nullopt;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Chosen chosen = fuzz::chosen(data, size);
    const Settled<std::vector<InputPolygon>> read = polygons_of_file(chosen.text, "fuzz.csv");
    require(read.value.has_value() == read.refusal.errors.empty());
    if (!read.value || read.value->size() > 4) return 0;
    LevelsPicture picture;
    picture.levels = {{0, {}}, {cycles, {}}};
    bool numbers = false;
    bool points = false;
    for (const InputPolygon& polygon : *read.value) {
        if (!fuzz::is_small(polygon)) continue;
        std::optional<std::array<PointStrands, 2>> drawings = drawings_of(polygon, chosen.choice);
        if (!drawings) continue;
        for (std::size_t i = 0; i < 2; ++i) {
            PointStrands& drawing = (*drawings)[i];
            if (drawing.size() > 0) require_written(drawing);
            numbers = numbers || drawing.dimension == 1;
            points = points || drawing.dimension > 1;
            picture.levels[i].parts.push_back(std::move(drawing));
        }
    }
    picture.axes = {.right = 0, .up = 1};
    if (numbers != points) require(!levels_picture(picture).empty());
    return 0;
}
