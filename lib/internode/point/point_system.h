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

#include "internode/expression/known_number.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/point/layout.h"
#include "internode/point/point_settings.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace internode {

struct DefinitionScope;
struct PointPrograms;

class PointSystem {
public:
    [[nodiscard]] const PointGrammar& grammar() const { return grammar_; }
    [[nodiscard]] std::size_t dimension() const { return dimension_; }
    /// The value of a definition without formals: finite.
    [[nodiscard]] const KnownNumber& constant(std::uint32_t definition) const { return constants_[definition]; }
    /// What expressions of the grammar may name; valid as long as the system.
    [[nodiscard]] DefinitionScope scope() const;
    /// Of the words of the derivation (pass 0), or after so many interpretation passes.
    [[nodiscard]] const Layout& layout(std::size_t passes = 0) const { return layouts_[passes]; }
    /// The table of each derivation step of a cycle; without tables, one step without a table.
    [[nodiscard]] std::span<const std::optional<std::uint32_t>> cycle() const { return cycle_; }
    /// The rules of a step, by index in grammar().rules and in their order.
    [[nodiscard]] std::span<const std::uint32_t> rules_of(std::optional<std::uint32_t> table) const {
        return rules_of_[table ? *table : 0];
    }
    /// Whether a rule of that table has a strict predecessor of several modules.
    [[nodiscard]] bool is_pseudo(std::optional<std::uint32_t> table) const;
    /// What a derivation runs (point/rule_programs.h).
    [[nodiscard]] const PointPrograms& programs() const { return *programs_; }
    /// Where the words come from, as the settings said.
    [[nodiscard]] PointStart start() const { return start_; }

private:
    friend class PointSystemMaker;
    PointGrammar grammar_;
    std::size_t dimension_ = 2;
    PointStart start_ = PointStart::Any;
    std::vector<KnownNumber> constants_; ///< one per definition; meaningful for constants
    std::vector<Layout> layouts_;        ///< 1 + passes
    std::vector<std::optional<std::uint32_t>> cycle_;
    std::vector<std::vector<std::uint32_t>> rules_of_; ///< per table; one entry without tables
    std::shared_ptr<const PointPrograms> programs_;
};

struct CheckedPointSystem {
    std::optional<PointSystem> system; ///< present iff problems is empty
    std::vector<PointProblem> problems;
};

/// Rules that no word can reach are not checked: their letters have no layout. Limits: at most 100,000 derivation steps
/// in a cycle; points of at most 64 coordinates; functions that explode when their calls are written out.
[[nodiscard]] CheckedPointSystem make_point_system(PointGrammar grammar, const PointSettings& settings = {});

} // namespace internode
