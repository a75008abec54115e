// SPDX-License-Identifier: MIT

#include "internode/point/module_word.h"

#include "internode/point/layouts.h"
#include "internode/point/module_writer.h"
#include "internode/text/number.h"

#include <algorithm>
#include <stdexcept>

namespace internode {

namespace {

/// A number, or a point in parentheses; what is left of the values.
std::span<const double> append_parameter(std::string& text, std::span<const double> values, Extent extent) {
    const std::size_t width = extent == 0 ? 1 : extent;
    if (extent > 0) text += '(';
    for (std::size_t i = 0; i < width; ++i) {
        if (i > 0) text += ", ";
        append(text, values[i]);
    }
    if (extent > 0) text += ')';
    return values.subspan(width);
}

void append_module(std::string& text, std::string_view name, std::span<const double> values,
                   std::span<const Extent> extents) {
    if (!text.empty()) text += ' ';
    text += name;
    if (values.empty()) return;
    text += '(';
    for (std::size_t k = 0; !values.empty(); ++k) {
        if (k > 0) text += ", ";
        values = append_parameter(text, values, k < extents.size() ? extents[k] : 0);
    }
    text += ')';
}

std::vector<KnownNumber> known_constants(const PointSystem& system) {
    std::vector<KnownNumber> known;
    for (std::uint32_t i = 0; i < system.grammar().definitions.size(); ++i)
        known.push_back({system.constant(i).exact, system.constant(i).value});
    return known;
}

/// Writes the modules of an input.
class TemplateWriter {
public:
    explicit TemplateWriter(const PointSystem& system)
        : constants_(known_constants(system))
        , maker_(system.grammar(), constants_)
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
    std::vector<KnownNumber> constants_;
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

void ModuleWord::push_back(Symbol letter, std::span<const double> values) {
    letters_.push_back(letter);
    first_.push_back(values_.size());
    values_.insert(values_.end(), values.begin(), values.end());
}

void ModuleWord::reserve(std::size_t modules, std::size_t values) {
    letters_.reserve(modules);
    first_.reserve(modules);
    values_.reserve(values);
}

std::string to_string(const ModuleWord& word, const PointGrammar& grammar, const Layout& layout) {
    std::string text;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const auto& parameters = layout[to_index(word.letter(i))];
        append_module(text, letter_text(grammar, word.letter(i)), word.values(i),
                      parameters ? std::span<const Extent>(*parameters) : std::span<const Extent>());
    }
    return text;
}

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
