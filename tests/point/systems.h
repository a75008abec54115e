// SPDX-License-Identifier: MIT
//
// What the tests of this room ask of point systems from text.

#pragma once

#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"
#include "tests/fixtures/point_systems.h"
#include "tests/fixtures/source_folder.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

using tests::point_grammar;
using tests::point_system;
using tests::text_of_data;

/// "message | hint" of each problem.
inline std::vector<std::string> problems_of(std::string_view text, const PointSettings& settings = {}) {
    std::vector<std::string> lines;
    for (const PointProblem& one : make_point_system(point_grammar(text), settings).problems)
        lines.push_back(one.hint.empty() ? one.message : one.message + " | " + one.hint);
    return lines;
}

/// What the first problem is about.
inline std::string place_of_first_problem(std::string_view text, const PointSettings& settings = {}) {
    const CheckedPointSystem made = make_point_system(point_grammar(text), settings);
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
    const PointSystem system = point_system(text);
    return shown(system, derived(system, axiom_word(system), cycles, options));
}

/// The coordinates of all points of a word.
inline std::vector<double> points_of(const PointSystem& system, const ModuleWord& word, std::size_t passes = 0) {
    return strands(word, system, passes).points;
}

} // namespace internode
