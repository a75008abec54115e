// SPDX-License-Identifier: MIT

#include "cli/compiled_points.h"

#include "internode/grammar/parse_points.h"
#include "internode/point/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace internode::cli {

namespace {

/// All points of a word, one after the other; false when they have several dimensions.
bool gather_points(const ModuleWord& word, const Layout& layout, CompiledPoints& result) {
    for (std::size_t i = 0; i < word.size(); ++i) {
        std::size_t value = 0;
        for (const Extent extent : layout[to_index(word.letter(i))].value_or(std::vector<Extent>())) {
            if (extent > 0) {
                if (result.dimension != 0 && result.dimension != extent) return false;
                result.dimension = extent;
                const auto point = word.values(i).subspan(value, extent);
                result.points.insert(result.points.end(), point.begin(), point.end());
            }
            value += std::max<std::size_t>(extent, 1);
        }
    }
    return result.dimension > 0;
}

std::string told(const LoadedPoints& loaded, const ExactStop& stop) {
    if (stop.place.bytes == 0) return stop.reason;
    const Diagnostic place = diagnostic_at(loaded.text.text, loaded.text.source, stop.place, {}, {});
    return fmt::format("line {}: {}", place.line, stop.reason);
}

/// \throw Failure (Refused) for more points than `most`, or more numbers than the interpreter may hold for them
RefinementPlan plan_within(const CompiledPoints& compiled, std::uint64_t cycles, std::uint64_t most) {
    const auto refusal = [&](const std::string& size) {
        return failure(
            ExitCode::Refused,
            fmt::format("after {} cycles the word would have {} points of {} coordinates; {} modules are allowed",
                        cycles, size, compiled.dimension, most),
            "fewer cycles, or a larger --max-modules");
    };
    try {
        RefinementPlan plan = compiled.grammar->plan(static_cast<int>(cycles));
        const std::uint64_t size = plan.output_size();
        if (size > most ||
            (compiled.dimension > values_per_module && size > most / compiled.dimension * values_per_module))
            throw refusal(std::to_string(size));
        return plan;
    } catch (const std::length_error&) {
        throw refusal("more than 2^62");
    }
}

} // namespace

CompiledPoints compiled_points(const LoadedPoints& loaded) {
    CompiledPoints result;
    if (loaded.derive.phase != 0) {
        result.reason = "a phase turns the ring";
        return result;
    }
    if (!gather_points(loaded.word, loaded.system.layout(), result)) {
        result.reason = "the word to start with has no points of one dimension";
        return result;
    }
    StartWord start;
    if (loaded.system.start() == PointStart::Input) start.points = loaded.polygon_size;
    Compilation compilation = compile(loaded.system, start);
    if (compilation.compiled)
        result.grammar = std::move(compilation.compiled);
    else
        result.reason = compilation.reasons.empty() ? "no reason" : told(loaded, compilation.reasons.front());
    return result;
}

std::optional<ModuleWord> compiled_word(const CompiledPoints& compiled, const LoadedPoints& loaded,
                                        std::uint64_t cycles, const CommonOptions& common) {
    const RefinementPlan plan = plan_within(compiled, cycles, loaded.derive.max_modules);
    std::vector<double> points(plan.output_size() * compiled.dimension);
    plan.apply<double>(compiled.points, compiled.dimension, points, {common.threads, common.isa});
    if (!std::ranges::all_of(points, [](double coordinate) { return std::isfinite(coordinate); })) return std::nullopt;
    return compiled.grammar->word(plan.final_cells(), points, compiled.dimension);
}

} // namespace internode::cli
