// SPDX-License-Identifier: MIT
//
// Neighbours along an axis are found once for a word by two walks with a stack, forth for left contexts and back for
// right ones. A ring is walked twice, the second time from where the first ended. A word without brackets needs no
// table.

#include "internode/point/matching.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

constexpr std::size_t no_module = static_cast<std::size_t>(-1);

/// The partner of each bracket; no_module for unbalanced ones and for all other modules.
std::vector<std::size_t> partners(std::span<const Symbol> letters, Symbol open, Symbol close) {
    std::vector<std::size_t> partner(letters.size(), no_module);
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (letters[i] == open) {
            waiting.push_back(i);
        } else if (letters[i] == close && !waiting.empty()) {
            partner[i] = waiting.back();
            partner[waiting.back()] = i;
            waiting.pop_back();
        }
    }
    return partner;
}

/// One way along the word: `neighbours` gets the last module of the axis of each. A branch is entered with the module
/// that its axis has so far, or as a new axis; it returns to `last`, the module before the branch.
class AxisWalk {
public:
    AxisWalk(std::vector<std::size_t>& neighbours, bool branch_continues)
        : neighbours_(neighbours)
        , branch_continues_(branch_continues) {}

    void visit(std::size_t i, bool enters, bool leaves) {
        neighbours_[i] = last_;
        if (enters) {
            stems_.push_back(last_);
            if (!branch_continues_) last_ = no_module;
        } else if (leaves) {
            assert(!stems_.empty() && "a branch that is left was entered");
            last_ = stems_.back();
            stems_.pop_back();
        } else {
            last_ = i;
        }
    }

private:
    std::vector<std::size_t>& neighbours_;
    bool branch_continues_;
    std::size_t last_ = no_module;
    std::vector<std::size_t> stems_;
};

} // namespace

WordShape::WordShape(std::span<const Symbol> letters, const PointGrammar& grammar)
    : letters_(letters)
    , ring_(grammar.ring) {
    const std::optional<Symbol> open = branch_open(grammar);
    const std::optional<Symbol> close = branch_close(grammar);
    if (!open || !close || std::ranges::find(letters_, *open) == letters_.end()) return;
    const std::vector<std::size_t> partner = partners(letters_, *open, *close);
    before_.assign(letters_.size(), no_module);
    after_.assign(letters_.size(), no_module);
    AxisWalk forth(before_, true);
    AxisWalk back(after_, false);
    // A ring is walked twice: the second time with the module that the first one ended at.
    for (int round = 0; round < (ring_ ? 2 : 1); ++round) {
        for (std::size_t i = 0; i < letters_.size(); ++i)
            forth.visit(i, partner[i] != no_module && letters_[i] == *open,
                        partner[i] != no_module && letters_[i] == *close);
        for (std::size_t i = letters_.size(); i-- > 0;)
            back.visit(i, partner[i] != no_module && letters_[i] == *close,
                       partner[i] != no_module && letters_[i] == *open);
    }
}

std::optional<std::size_t> WordShape::before(std::size_t i) const {
    assert(i < letters_.size());
    if (!before_.empty()) return before_[i] == no_module ? std::nullopt : std::optional(before_[i]);
    if (i > 0) return i - 1;
    return ring_ ? std::optional(letters_.size() - 1) : std::nullopt;
}

std::optional<std::size_t> WordShape::after(std::size_t i) const {
    assert(i < letters_.size());
    if (!after_.empty()) return after_[i] == no_module ? std::nullopt : std::optional(after_[i]);
    if (i + 1 < letters_.size()) return i + 1;
    return ring_ ? std::optional<std::size_t>(0) : std::nullopt;
}

bool WordShape::fits(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules,
                     std::uint64_t* compared) const {
    assert(i < letters_.size() && !rule.predecessor.empty());
    const std::size_t count = rule.predecessor.size();
    std::size_t equal = 0;
    while (equal < count && equal < letters_.size() - i && rule.predecessor[equal] == letters_[i + equal]) ++equal;
    modules.clear();
    const bool result = equal == count && fits_left(rule, i, modules) && fits_right(rule, i, modules);
    if (compared != nullptr) *compared += 1 + equal + modules.size();
    return result;
}

/// Appends the modules of the left context and of the strict predecessor.
bool WordShape::fits_left(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const {
    std::size_t at = i;
    for (std::size_t k = rule.left.size(); k-- > 0;) {
        const std::optional<std::size_t> next = before(at);
        if (!next || letters_[*next] != rule.left[k]) return false;
        modules.push_back(at = *next);
    }
    std::ranges::reverse(modules);
    for (std::size_t k = 0; k < rule.predecessor.size(); ++k) modules.push_back(i + k);
    return true;
}

bool WordShape::fits_right(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const {
    std::size_t at = i + rule.predecessor.size() - 1;
    for (const Symbol letter : rule.right) {
        const std::optional<std::size_t> next = after(at);
        if (!next || letters_[*next] != letter) return false;
        modules.push_back(at = *next);
    }
    return true;
}

} // namespace internode
