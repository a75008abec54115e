// SPDX-License-Identifier: MIT

#include "cli/points/compiled_points.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/point/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace internode::cli {

namespace {

std::string told(const LoadedPoints& loaded, const ExactStop& stop) {
    if (stop.place.bytes == 0) return stop.reason;
    const Diagnostic place = diagnostic_at(loaded.text.text, loaded.text.source, stop.place, {}, {});
    return fmt::format("line {}: {}", place.line, stop.reason);
}

/// \throw Failure (Refused) for more modules than allowed, or more numbers than the interpreter may hold for them
void refuse_size(const CompiledGrammar::WordSize& size, std::size_t dimension, std::uint64_t cycles,
                 std::uint64_t most) {
    const bool has_room = size.numbers / values_per_module <= most &&
                          (dimension <= values_per_module || size.points <= most / dimension * values_per_module);
    if (size.modules <= most && size.points <= most && has_room) return;
    throw failure(ExitCode::Refused,
                  fmt::format("after {} cycles the word would have {} modules and {} points of {} coordinates; {} "
                              "modules are allowed",
                              cycles, size.modules, size.points, dimension, most),
                  "fewer cycles, or a larger --max-modules");
}

} // namespace

CompiledPoints compiled_points(const LoadedPoints& loaded) {
    CompiledPoints result;
    if (loaded.derive.phase != 0) {
        result.reason = "a phase turns the ring";
        return result;
    }
    StartWord start;
    if (loaded.system.start() == PointStart::Input) start.points = loaded.polygon_size;
    Compilation compilation = compile(loaded.system, start);
    if (!compilation.compiled) {
        result.reason = told(loaded, compilation.reasons.front());
        return result;
    }
    result.grammar = std::move(compilation.compiled);
    result.points = cell_points(loaded.word, loaded.system);
    result.dimension = result.points.size() / result.grammar->cells().size();
    return result;
}

std::optional<ModuleWord> compiled_word(const CompiledPoints& compiled, const LoadedPoints& loaded,
                                        std::uint64_t cycles, const CommonOptions& common) {
    const CompiledGrammar::WordSize size = compiled.grammar->size(cycles);
    if (size.points == 0) return std::nullopt; // only the interpreter knows modules without any point
    refuse_size(size, compiled.dimension, cycles, loaded.derive.max_modules);
    const RefinementPlan plan = compiled.grammar->plan(static_cast<int>(cycles));
    std::vector<double> points(plan.output_size() * compiled.dimension);
    plan.apply<double>(compiled.points, compiled.dimension, points, {common.threads, common.isa});
    if (!std::ranges::all_of(points, [](double coordinate) { return std::isfinite(coordinate); })) return std::nullopt;
    return compiled.grammar->word(plan.final_cells(), points, compiled.dimension);
}

} // namespace internode::cli
