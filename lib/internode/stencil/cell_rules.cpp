// SPDX-License-Identifier: MIT
//
// Moore's partition: a round gives one class to the states with the same signature, which is their old class and the
// label and class of every child. Rounds end when the number of classes stays. Rows are numbered once beforehand, so
// that rounds compare integers.

#include "internode/stencil/cell_rules.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <map>
#include <stdexcept>
#include <unordered_map>

namespace internode {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Numbers rows, the same for equal ones.
class RowNumbers {
public:
    std::uint32_t of(const CellRow& row) {
        std::uint64_t hash = static_cast<std::uint64_t>(row.first);
        for (const Number& weight : row.weights)
            hash = (std::rotl(hash, 7) ^ std::bit_cast<std::uint64_t>(weight.to_double())) * 0x9e3779b97f4a7c15U;
        std::vector<std::uint32_t>& candidates = known_[hash];
        for (const std::uint32_t number : candidates)
            if (*rows_[number] == row) return number;
        candidates.push_back(static_cast<std::uint32_t>(rows_.size()));
        rows_.push_back(&row);
        return candidates.back();
    }

private:
    std::vector<const CellRow*> rows_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> known_;
};

/// The class of each signature, numbered in the order of arrival.
using Signature = std::vector<std::uint32_t>;

std::vector<std::uint32_t> numbered(const std::vector<Signature>& signatures) {
    std::map<Signature, std::uint32_t> classes;
    std::vector<std::uint32_t> result;
    result.reserve(signatures.size());
    for (const Signature& signature : signatures)
        result.push_back(classes.try_emplace(signature, static_cast<std::uint32_t>(classes.size())).first->second);
    return result;
}

std::size_t class_count(const std::vector<std::uint32_t>& classes) {
    return classes.empty() ? 0 : std::ranges::max(classes) + std::size_t{1};
}

/// Where the rows of a state lie together: 0 … -1 when all are empty.
struct Reach {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = -1;
};

Reach reach_of(const std::vector<CellChild>& children) {
    Reach reach;
    for (const CellChild& child : children) {
        if (child.row.weights.empty()) continue;
        const std::ptrdiff_t last = child.row.first + static_cast<std::ptrdiff_t>(child.row.weights.size()) - 1;
        const bool is_first = reach.last < reach.first;
        reach.first = is_first ? child.row.first : std::min(reach.first, child.row.first);
        reach.last = is_first ? last : std::max(reach.last, last);
    }
    return reach;
}

} // namespace

class CellAutomatonBuilder {
public:
    static CellAutomaton build(const CellRules& rules) {
        CellAutomaton automaton;
        std::vector<Reach> reaches;
        for (const std::vector<CellChild>& children : rules) {
            reaches.push_back(reach_of(children));
            const auto width = static_cast<std::size_t>(reaches.back().last - reaches.back().first + 1);
            automaton.width_ = std::max(automaton.width_, width);
        }
        std::map<std::pair<std::uint32_t, std::ptrdiff_t>, std::uint32_t> placed; // a row at its place in the width
        const std::vector<std::uint32_t> labels = row_labels(rules);
        std::size_t label = 0;
        for (std::size_t state = 0; state < rules.size(); ++state) {
            automaton.offset_.push_back(static_cast<std::int32_t>(reaches[state].first));
            automaton.first_child_.push_back(automaton.children_.size());
            for (const CellChild& child : rules[state]) {
                if (child.state >= rules.size()) throw std::invalid_argument("a child without a state");
                const std::ptrdiff_t place = child.row.weights.empty() ? 0 : child.row.first - reaches[state].first;
                const auto [row, is_new] =
                    placed.try_emplace({labels[label++], place}, static_cast<std::uint32_t>(automaton.row_count()));
                if (is_new) add_row(automaton, child.row, static_cast<std::size_t>(place));
                automaton.children_.push_back({child.state, row->second});
            }
        }
        assert(label == labels.size());
        automaton.first_child_.push_back(automaton.children_.size());
        return automaton;
    }

private:
    static void add_row(CellAutomaton& automaton, const CellRow& row, std::size_t place) {
        std::vector<Number> whole(automaton.width_);
        assert(place + row.weights.size() <= automaton.width_);
        std::ranges::copy(row.weights, whole.begin() + static_cast<std::ptrdiff_t>(place));
        for (const Number& weight : whole) {
            automaton.weights_.push_back(weight.to_double());
            automaton.exact_.push_back(weight);
        }
    }
};

CellRow trimmed(CellRow row) {
    const auto is_zero = [](const Number& weight) { return weight.sign() == 0; };
    while (!row.weights.empty() && is_zero(row.weights.back())) row.weights.pop_back();
    const auto first = std::ranges::find_if_not(row.weights, is_zero);
    row.first = row.weights.empty() ? 0 : row.first + (first - row.weights.begin());
    row.weights.erase(row.weights.begin(), first);
    return row;
}

CellAutomaton make_cell_automaton(const CellRules& rules) {
    return CellAutomatonBuilder::build(rules);
}

CellRules rules_of(const CellAutomaton& automaton) {
    CellRules rules(automaton.state_count());
    for (std::uint32_t state = 0; state < rules.size(); ++state)
        for (const CellAutomaton::Child& child : automaton.children(state)) {
            assert(child.row < automaton.row_count());
            const auto weights = automaton.exact_weights(child.row);
            rules[state].push_back({child.state, trimmed({automaton.offset(state), {weights.begin(), weights.end()}})});
        }
    return rules;
}

std::vector<std::uint32_t> row_labels(const CellRules& rules) {
    RowNumbers numbers;
    std::vector<std::uint32_t> labels;
    for (const std::vector<CellChild>& children : rules)
        for (const CellChild& child : children) labels.push_back(numbers.of(child.row));
    return labels;
}

std::vector<std::uint32_t> equivalent_states(const CellRules& rules, std::span<const std::uint32_t> labels,
                                             std::span<const std::uint32_t> colors) {
    assert(colors.empty() || colors.size() == rules.size());
    std::vector<std::uint32_t> classes(colors.begin(), colors.end());
    classes.resize(rules.size());
    std::size_t count = 0;
    for (;;) {
        std::vector<Signature> signatures;
        signatures.reserve(rules.size());
        std::size_t label = 0;
        for (std::size_t state = 0; state < rules.size(); ++state) {
            Signature signature{classes[state]};
            for (const CellChild& child : rules[state]) {
                signature.push_back(labels[label++]);
                signature.push_back(classes[child.state]);
            }
            signatures.push_back(std::move(signature));
        }
        assert(label == labels.size());
        classes = numbered(signatures);
        // Each round only splits classes.
        assert(class_count(classes) >= count);
        if (class_count(classes) == count) return classes;
        count = class_count(classes);
    }
}

NormalForm normal_form(const CellRules& rules, std::span<const std::uint32_t> start) {
    const std::vector<std::uint32_t> classes = equivalent_states(rules, row_labels(rules));
    std::vector<std::uint32_t> number(class_count(classes), none); // of each class, in the order of meeting
    std::vector<std::uint32_t> example;                            // a state of each
    NormalForm normal;
    const auto meet = [&](std::uint32_t state) {
        assert(state < classes.size());
        std::uint32_t& known = number[classes[state]];
        if (known == none) {
            known = static_cast<std::uint32_t>(example.size());
            example.push_back(state);
        }
        return known;
    };
    for (const std::uint32_t state : start) normal.start.push_back(meet(state));
    std::optional<std::ptrdiff_t> origin;
    for (std::size_t state = 0; state < example.size(); ++state) {
        normal.rules.emplace_back();
        for (CellChild child : rules[example[state]]) {
            child.state = meet(child.state);
            if (!child.row.weights.empty()) {
                if (!origin) origin = child.row.first;
                child.row.first -= *origin;
            }
            normal.rules.back().push_back(std::move(child));
        }
    }
    return normal;
}

} // namespace internode
