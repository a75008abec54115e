// SPDX-License-Identifier: MIT
//
// A word of modules with their parameters, in doubles: A(4) A(3.5) P((0, 1), 2).
//
// Letters and values stand apart, each in one array. The values of a module are its parameters in their order, a number
// as one double and a point as its coordinates (the layout of the letter says which, point/layout.h).

#pragma once

#include "internode/grammar/points/point_grammar.h"
#include "internode/point/layout.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace internode {

class ModuleWord {
public:
    [[nodiscard]] std::size_t size() const { return letters_.size(); }
    [[nodiscard]] bool empty() const { return letters_.empty(); }
    [[nodiscard]] Symbol letter(std::size_t i) const { return letters_[i]; }
    [[nodiscard]] std::span<const Symbol> letters() const { return letters_; }
    /// All values of module i.
    [[nodiscard]] std::span<const double> values(std::size_t i) const {
        return {values_.data() + first_[i], (i + 1 < first_.size() ? first_[i + 1] : values_.size()) - first_[i]};
    }
    [[nodiscard]] std::span<double> values(std::size_t i) {
        return {values_.data() + first_[i], (i + 1 < first_.size() ? first_[i + 1] : values_.size()) - first_[i]};
    }
    /// Of all modules together.
    [[nodiscard]] std::size_t value_count() const { return values_.size(); }
    void push_back(Symbol letter, std::span<const double> values);
    void reserve(std::size_t modules, std::size_t values);
    friend bool operator==(const ModuleWord&, const ModuleWord&) = default;

private:
    std::vector<Symbol> letters_;
    std::vector<std::size_t> first_; ///< where each module's values begin
    std::vector<double> values_;
};

/// S0 eq. 12, a blank between modules: `A(4) A(3.5) A(7.5) B(10)`; points in parentheses, numbers by shortest round
/// trip.
[[nodiscard]] std::string to_string(const ModuleWord& word, const PointGrammar& grammar, const Layout& layout);

} // namespace internode
