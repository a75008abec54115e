// SPDX-License-Identifier: MIT

#include "internode/point/start_word.h"

#include "internode/point/effective_input.h"
#include "internode/point/module_writer.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// Writes the modules of an input.
class TemplateWriter {
public:
    explicit TemplateWriter(const PointSystem& system)
        : maker_(system.scope())
        , writer_(maker_.functions()) {}

    [[nodiscard]] std::vector<ModulePrograms> compile(std::span<const ModuleTemplate> modules,
                                                      std::span<const Extent> extents) {
        std::vector<ModulePrograms> programs;
        for (const ModuleTemplate& one : modules) {
            programs.push_back({one.letter, {}});
            for (const Expression& argument : one.arguments)
                programs.back().arguments.push_back(maker_.make(argument, extents));
        }
        return programs;
    }
    void write(const ModulePrograms& programs, std::span<const double> formals, ModuleWord& word) {
        if (writer_.write(programs, formals, word)) throw std::invalid_argument("a parameter is not finite");
    }

private:
    ProgramMaker maker_;
    ModuleWriter writer_;
};

/// The input for polygons: also `P(v)` of a grammar with an axiom, where its words have the same `P`.
PointInput usable_input(const PointSystem& system) {
    std::optional<PointInput> input = effective_input(system.grammar(), system.start());
    if (input) return std::move(*input);
    input = system.start() == PointStart::Axiom ? std::nullopt : default_input(system.grammar());
    if (input) {
        const auto& parameters = system.layout()[to_index(input->each.front().letter)];
        if (parameters && *parameters == std::vector<Extent>{static_cast<Extent>(system.dimension())})
            return std::move(*input);
    }
    throw std::invalid_argument("nothing says what the points of a polygon become");
}

} // namespace

ModuleWord axiom_word(const PointSystem& system) {
    if (!system.grammar().axiom || system.start() == PointStart::Input)
        throw std::invalid_argument("no word begins the derivation: the grammar has no axiom");
    return system.programs().axiom;
}

ModuleWord input_word(const PointSystem& system, std::span<const double> points) {
    const std::size_t dimension = system.dimension();
    if (points.empty() || points.size() % dimension != 0)
        throw std::invalid_argument("a polygon of no point, or of points of another dimension");
    const PointInput input = usable_input(system);
    const std::vector<Extent> extents{static_cast<Extent>(dimension)};
    TemplateWriter writer(system);
    const std::vector<ModulePrograms> first = writer.compile(input.first, extents);
    const std::vector<ModulePrograms> each = writer.compile(input.each, extents);
    const std::vector<ModulePrograms> last = writer.compile(input.last, extents);
    assert(dimension > 0);
    const std::size_t count = points.size() / dimension;
    ModuleWord word;
    for (std::size_t k = 0; k < count; ++k) {
        const bool begins = input.has_ends && k == 0;
        const bool ends = input.has_ends && k + 1 == count && !begins;
        for (const ModulePrograms& one : begins ? first : ends ? last : each)
            writer.write(one, points.subspan(k * dimension, dimension), word);
    }
    return word;
}

} // namespace internode
