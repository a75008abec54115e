// SPDX-License-Identifier: MIT
//
// A point grammar that can be run: constants have values, every parameter of every letter is known to be a number or a
// point, and each cycle is a list of derivation steps.
//
// The kinds of the parameters follow from the input and the axiom through the successors of the rules, to a fixed
// point: what a rule reads is what some word can hold. A parameter that could be a point here and a number there, a
// sum of a number and a point, a condition that is no truth are problems with their place. After each interpretation
// pass the kinds are others (S1 eq. 20 makes P'(2 coordinates) of P(3 coordinates)).

#pragma once

#include "internode/grammar/point_grammar.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace internode {

/// 0: a number; k >= 1: a point of k coordinates.
using Extent = std::uint32_t;

/// The parameters of each letter: none where no word has the letter.
using Layout = std::vector<std::optional<std::vector<Extent>>>;

struct PointSettings {
    std::size_t dimension = 2;                 ///< coordinates of the points of the input
    std::map<std::string, Rational> constants; ///< values of constants, instead of the grammar's
};

struct ConstantValue {
    double value = 0;              ///< finite; the nearest double where `exact` is present
    std::optional<Rational> exact; ///< none where a square root came in
};

/// A fact about the grammar that a user has to mend.
struct PointProblem {
    SourcePlace place;
    std::string message;
    std::string hint; ///< may be empty
};

class PointSystem {
public:
    [[nodiscard]] const PointGrammar& grammar() const { return grammar_; }
    [[nodiscard]] std::size_t dimension() const { return dimension_; }
    /// Of a definition without formals.
    [[nodiscard]] const ConstantValue& constant(std::uint32_t definition) const { return constants_[definition]; }
    /// Of the words of the derivation (pass 0), or after so many interpretation passes.
    [[nodiscard]] const Layout& layout(std::size_t passes = 0) const { return layouts_[passes]; }
    /// The table of each derivation step of a cycle; without tables, one step without a table.
    [[nodiscard]] std::span<const std::optional<std::uint32_t>> cycle() const { return cycle_; }
    /// The rules of a step, by index in grammar().rules and in their order.
    [[nodiscard]] std::span<const std::uint32_t> rules_of(std::optional<std::uint32_t> table) const {
        return rules_of_[table ? *table : 0];
    }
    /// Whether a strict predecessor of several modules begins with this letter, in a step of that table.
    [[nodiscard]] bool is_pseudo(std::optional<std::uint32_t> table) const;

private:
    friend class PointSystemMaker;
    PointGrammar grammar_;
    std::size_t dimension_ = 2;
    std::vector<ConstantValue> constants_; ///< one per definition; meaningful for constants
    std::vector<Layout> layouts_;          ///< 1 + passes
    std::vector<std::optional<std::uint32_t>> cycle_;
    std::vector<std::vector<std::uint32_t>> rules_of_; ///< per table; one entry without tables
};

struct CheckedPointSystem {
    std::optional<PointSystem> system; ///< present iff problems is empty
    std::vector<PointProblem> problems;
};

/// Limits: at most 100,000 derivation steps in a cycle; dimension 1 … 64.
[[nodiscard]] CheckedPointSystem make_point_system(PointGrammar grammar, const PointSettings& settings = {});

} // namespace internode
