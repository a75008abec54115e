// SPDX-License-Identifier: MIT
//
// Where a rule fits in a word, by its letters alone: contexts step over branches, rings go round.
//
// A left context reads the modules before the strict predecessor towards the root. Whole branches `[ … ]` on the way
// are stepped over, and a `[` that is not closed on the way leads to the module before it. A right context reads the
// modules after it on the same axis: whole branches are stepped over, and a `]` ends the axis. In a ring the word
// continues at its other end, as often as needed, and contexts may read the strict predecessor itself.

#pragma once

#include "internode/grammar/points/point_grammar.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace internode {

/// The letters of a word and, where it has brackets, the neighbours of each on its axis; made once per word. Cost:
/// linear.
class WordShape {
public:
    /// `letters` must outlive the shape. An unbalanced bracket is read as a module that is never stepped over.
    WordShape(std::span<const Symbol> letters, const PointGrammar& grammar);

    [[nodiscard]] std::size_t size() const { return letters_.size(); }
    [[nodiscard]] Symbol letter(std::size_t i) const { return letters_[i]; }
    /// The module before i, or after it, on its axis, as contexts see it; none at the end of the axis. Cost: constant.
    [[nodiscard]] std::optional<std::size_t> before(std::size_t i) const;
    [[nodiscard]] std::optional<std::size_t> after(std::size_t i) const;

    /// Whether the rule fits with its strict predecessor at i, i+1, … (which never goes round the end of the word, nor
    /// over a bracket). If so, `modules` holds the positions of all modules of left, predecessor and right, in the
    /// order of the rule's formals. Cost: the letters compared, at most those of the rule; they are added to
    /// `compared`.
    [[nodiscard]] bool fits(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules,
                            std::uint64_t* compared = nullptr) const;

private:
    bool fits_left(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const;
    bool fits_right(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const;

    std::span<const Symbol> letters_;
    bool ring_ = false;
    std::vector<std::size_t> before_; ///< empty when the word has no brackets
    std::vector<std::size_t> after_;
};

} // namespace internode
