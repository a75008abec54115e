// SPDX-License-Identifier: MIT
//
// Any bytes that are a point grammar and a system are derived and interpreted. Nothing crashes, words and work keep
// their limits, what was predicted is what comes, all numbers are finite, and everything is the same the second time.

#include "internode/grammar/points/parse_points.h"
#include "internode/point/growth.h"
#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace {

using namespace internode;
using fuzz::require;

DeriveOptions options() {
    DeriveOptions options;
    options.max_modules = 2000;
    options.max_work = 3'000'000;
    options.seed = 7;
    options.query = [](const ModuleWord& word, std::size_t position, std::span<double> values) {
        values[0] = static_cast<double>(position) / static_cast<double>(word.size());
        return position % 2 == 0;
    };
    return options;
}

void require_sound(const Derivation& done, const PointSystem& system, std::size_t passes,
                   const DeriveOptions& options) {
    for (std::size_t i = 0; i < done.word.size(); ++i) {
        require(to_index(done.word.letter(i)) < system.grammar().letters.size());
        for (const double value : done.word.values(i)) require(std::isfinite(value));
    }
    static_cast<void>(to_string(done.word, system.grammar(), system.layout(passes)));
    const PointStrands drawing = strands(done.word, system, passes);
    for (const PointStrands::Strand& strand : drawing.strands)
        for (const std::size_t point : strand.points) require(point < drawing.size());
    if (done.problem) require(!done.problem->message.empty());
    if (!done.problem) require(done.word.size() <= options.max_modules);
}

void derive_word(const PointSystem& system, const ModuleWord& word) {
    const DeriveOptions chosen = options();
    if (word.size() > chosen.max_modules) return;
    const Derivation done = derive(system, word, 3, chosen);
    require_sound(done, system, 0, chosen);
    const Derivation again = derive(system, word, 3, chosen);
    require(again.word == done.word && again.work == done.work);
    const std::optional<std::uint64_t> length = predicted_length(system, word, 3, chosen.max_modules);
    if (length && !done.problem) require(*length == done.word.size());
    if (length && *length > chosen.max_modules) require(done.problem.has_value());
    const Derivation drawn = interpret(system, done.word, chosen);
    if (!drawn.problem) require_sound(drawn, system, system.grammar().interpretations.size(), chosen);
}

/// None where there is no input, or where it makes what is not finite.
std::optional<ModuleWord> polygon_word(const PointSystem& system) {
    const std::vector<double> points{0, 0, 0, 1, 1, 1, 1, 0, 2, 3};
    try {
        return input_word(system, points);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    ParsedPointGrammar parsed = parse_point_grammar(text, "<fuzz>");
    if (!parsed.grammar) return 0;
    const bool has_axiom = parsed.grammar->axiom.has_value();
    const CheckedPointSystem made = make_point_system(std::move(*parsed.grammar));
    require(made.system.has_value() == made.problems.empty());
    for (const PointProblem& problem : made.problems) require(problem.place.offset + problem.place.bytes <= size);
    if (!made.system) return 0;
    if (has_axiom) derive_word(*made.system, axiom_word(*made.system));
    if (const std::optional<ModuleWord> word = polygon_word(*made.system)) derive_word(*made.system, *word);
    return 0;
}
