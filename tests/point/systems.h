// SPDX-License-Identifier: MIT
//
// Point systems from text, for tests.

#pragma once

#include "internode/grammar/points/parse_points.h"
#include "internode/point/interpreter.h"
#include "tests/fixtures/source_folder.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

inline PointGrammar grammar_of(std::string_view text) {
    ParsedPointGrammar parsed = parse_point_grammar(text, "<test>");
    if (!parsed.grammar) throw std::runtime_error(to_string(parsed.errors));
    return std::move(*parsed.grammar);
}

inline PointSystem system_of(std::string_view text, const PointSettings& settings = {}) {
    CheckedPointSystem made = make_point_system(grammar_of(text), settings);
    if (!made.system) throw std::runtime_error(made.problems.front().message);
    return std::move(*made.system);
}

/// The text of a grammar of data/grammars, by its path there: "s0/13".
inline std::string text_of_data(const std::string& name) {
    std::ifstream file(tests::in_source_folder("data/grammars/") + name + ".lsys");
    if (!file) throw std::runtime_error("no grammar " + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// "message | hint" of each problem.
inline std::vector<std::string> problems_of(std::string_view text, const PointSettings& settings = {}) {
    std::vector<std::string> lines;
    for (const PointProblem& one : make_point_system(grammar_of(text), settings).problems)
        lines.push_back(one.hint.empty() ? one.message : one.message + " | " + one.hint);
    return lines;
}

/// What the first problem is about.
inline std::string place_of_first_problem(std::string_view text, const PointSettings& settings = {}) {
    const CheckedPointSystem made = make_point_system(grammar_of(text), settings);
    if (made.problems.empty()) return "no problem";
    const SourcePlace& place = made.problems.front().place;
    return std::string(text.substr(place.offset, place.bytes));
}

inline ModuleWord derived(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                          const DeriveOptions& options = {}) {
    Derivation done = derive(system, word, cycles, options);
    if (done.problem) throw std::runtime_error(done.problem->message);
    return std::move(done.word);
}

inline std::string shown(const PointSystem& system, const ModuleWord& word, std::size_t passes = 0) {
    return to_string(word, system.grammar(), system.layout(passes));
}

/// The word after so many cycles from the axiom.
inline std::string after(std::string_view text, std::uint64_t cycles, const DeriveOptions& options = {}) {
    const PointSystem system = system_of(text);
    return shown(system, derived(system, axiom_word(system), cycles, options));
}

/// The coordinates of all points of a word.
inline std::vector<double> points_of(const PointSystem& system, const ModuleWord& word, std::size_t passes = 0) {
    return strands(word, system, passes).points;
}

} // namespace internode
