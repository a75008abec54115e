// SPDX-License-Identifier: MIT
//
// Modules without their points: letters with exact numbers, counted as they are met.

#pragma once

#include "internode/point/compile/exact_word.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace internode {

/// A module by its letter and its numbers, without its points.
struct ModuleKind {
    Symbol letter{};
    std::vector<Rational> numbers;
    friend bool operator==(const ModuleKind&, const ModuleKind&) = default;
};

/// Numbers the kinds of modules.
class KindTable {
public:
    explicit KindTable(const PointSystem& system);

    /// The kind of a module, whose values are as the layout says.
    [[nodiscard]] std::uint32_t of(const ExactModule& module);
    [[nodiscard]] const std::vector<ModuleKind>& kinds() const { return kinds_; }
    /// Which parameters of a letter are points.
    [[nodiscard]] const std::vector<bool>& points_of(Symbol letter) const { return is_point_[to_index(letter)]; }
    [[nodiscard]] std::size_t point_count(std::uint32_t kind) const { return counts_[kind]; }
    /// A module of that kind with the points p_next, p_{next+1}, …; `next` moves on.
    [[nodiscard]] ExactModule module(std::uint32_t kind, std::ptrdiff_t& next) const;

private:
    std::vector<std::vector<bool>> is_point_; ///< per letter, per parameter
    std::vector<ModuleKind> kinds_;
    std::vector<std::size_t> counts_;
    std::map<std::pair<Symbol, std::vector<Rational>>, std::uint32_t> numbers_;
};

/// How many of its parameters are points.
[[nodiscard]] std::size_t points_in(const ExactModule& module);

} // namespace internode
