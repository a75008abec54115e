// SPDX-License-Identifier: MIT
//
// Point grammars for tests: from text, from the bundled ones, and random affine ones.

#pragma once

#include "internode/grammar/points/parse_points.h"
#include "internode/point/point_system.h"
#include "tests/fixtures/source_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace internode::reference {

/// \throw std::runtime_error with all errors
inline PointSystem point_system(const std::string& text, const PointSettings& settings = {}) {
    const ParsedPointGrammar parsed = parse_point_grammar(text, "<test>");
    if (!parsed.grammar) throw std::runtime_error(to_string(parsed.errors));
    CheckedPointSystem checked = make_point_system(*parsed.grammar, settings);
    if (!checked.system) throw std::runtime_error(checked.problems.front().message);
    return *std::move(checked.system);
}

/// Of data/grammars, by its name without `@`. \throw std::runtime_error
inline PointSystem bundled_system(const std::string& name, const PointSettings& settings = {}) {
    std::ifstream file(tests::in_source_folder("data/grammars/") + name + ".lsys");
    std::stringstream text;
    text << file.rdbuf();
    return point_system(text.str(), settings);
}

/// An affine combination of the given points, in sixteenths: "3/16 u - 1/16 v + 14/16 w".
inline std::string random_combination(const std::vector<std::string>& points, std::mt19937& random) {
    std::string text;
    int rest = 16;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool last = i + 1 == points.size();
        const int weight = last ? rest : std::uniform_int_distribution<int>(-4, 8)(random);
        rest -= weight;
        text += fmt::format("{}({}/16) {}", text.empty() ? "" : " + ", weight, points[i]);
    }
    return text;
}

/// A rule of P with `left` and `right` context points (ends where asked) and one to three successors.
inline std::string random_rule(std::size_t left, std::size_t right, bool left_end, bool right_end,
                               std::mt19937& random) {
    std::vector<std::string> points;
    std::string before = left_end ? "# " : "";
    std::string after;
    for (std::size_t i = 0; i < left; ++i) {
        points.push_back(fmt::format("l{}", i));
        before += fmt::format("P(l{}) ", i);
    }
    points.emplace_back("v");
    for (std::size_t i = 0; i < right; ++i) {
        points.push_back(fmt::format("r{}", i));
        after += fmt::format("P(r{}) ", i);
    }
    if (right_end) after += "#";
    std::string rule = before.empty() ? "P(v)" : before + "< P(v)";
    if (!after.empty()) rule += " > " + after;
    rule += " ->";
    const int count = std::uniform_int_distribution<int>(2, 3)(random);
    for (int i = 0; i < count; ++i) rule += " P(" + random_combination(points, random) + ")";
    return rule;
}

/// A ring grammar with one rule, or an open one with rules near its ends: all its points have a rule of their own.
inline std::string random_affine_grammar(bool ring, std::mt19937& random) {
    const auto reach = [&random] { return std::uniform_int_distribution<std::size_t>(0, 2)(random); };
    std::string text = ring ? "points\nring\ninput P(v)\n" : "points\ninput # P(v) #\n";
    if (!ring) {
        text += random_rule(0, reach(), true, false, random) + "\n";
        text += random_rule(1, reach(), true, false, random) + "\n";
        text += random_rule(reach(), 0, false, true, random) + "\n";
    }
    text += random_rule(reach(), reach(), false, false, random) + "\n";
    if (!ring) text += random_rule(0, 0, false, false, random) + "\n";
    return text;
}

} // namespace internode::reference
