// SPDX-License-Identifier: MIT

#include "internode/point/matching.h"

#include <algorithm>

namespace internode {
namespace {

constexpr std::size_t unpaired = static_cast<std::size_t>(-1);

} // namespace

WordShape::WordShape(std::span<const Symbol> letters, const PointGrammar& grammar)
    : letters_(letters)
    , ring_(grammar.ring)
    , open_(branch_open(grammar))
    , close_(branch_close(grammar)) {
    if (!open_ || !close_ || std::ranges::find(letters_, *open_) == letters_.end()) return;
    partner_.assign(letters_.size(), unpaired);
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < letters_.size(); ++i) {
        if (letters_[i] == *open_) {
            waiting.push_back(i);
        } else if (letters_[i] == *close_ && !waiting.empty()) {
            partner_[i] = waiting.back();
            partner_[waiting.back()] = i;
            waiting.pop_back();
        }
    }
}

std::optional<std::size_t> WordShape::before(std::size_t i) const {
    // A ring is left when all of it is brackets.
    for (std::size_t steps = 0; steps <= letters_.size(); ++steps) {
        if (i == 0 && !ring_) return std::nullopt;
        i = i == 0 ? letters_.size() - 1 : i - 1;
        if (partner_.empty() || partner_[i] == unpaired) return i;
        if (letters_[i] == *close_) i = partner_[i];
    }
    return std::nullopt;
}

std::optional<std::size_t> WordShape::after(std::size_t i) const {
    for (std::size_t steps = 0; steps <= letters_.size(); ++steps) {
        if (i + 1 == letters_.size() && !ring_) return std::nullopt;
        i = i + 1 == letters_.size() ? 0 : i + 1;
        if (partner_.empty() || partner_[i] == unpaired) return i;
        if (letters_[i] == *close_) return std::nullopt;
        i = partner_[i];
    }
    return std::nullopt;
}

bool WordShape::fits(const PointRule& rule, std::size_t i, std::vector<std::size_t>& modules) const {
    const std::size_t count = rule.predecessor.size();
    if (count > letters_.size() - i) return false;
    if (!std::ranges::equal(rule.predecessor, letters_.subspan(i, count))) return false;
    modules.resize(rule.left.size() + count + rule.right.size());
    std::size_t at = i;
    for (std::size_t k = rule.left.size(); k-- > 0;) {
        const std::optional<std::size_t> next = before(at);
        if (!next || letters_[*next] != rule.left[k]) return false;
        modules[k] = at = *next;
    }
    for (std::size_t k = 0; k < count; ++k) modules[rule.left.size() + k] = i + k;
    at = i + count - 1;
    for (std::size_t k = 0; k < rule.right.size(); ++k) {
        const std::optional<std::size_t> next = after(at);
        if (!next || letters_[*next] != rule.right[k]) return false;
        modules[rule.left.size() + count + k] = at = *next;
    }
    return true;
}

} // namespace internode
