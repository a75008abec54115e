// SPDX-License-Identifier: MIT

#include "internode/report/picture/tree_layout.h"

#include <algorithm>

namespace internode {

namespace {

/// The modules of one word that belong together, and what became of them.
struct Family {
    std::size_t first = 0;
    std::size_t size = 1;
    std::vector<std::size_t> children; ///< of the next word
    double width = 0;
    double children_width = 0;
};

/// The families of a word, from left to right. A strict predecessor across the seam of a ring ends at the seam here.
std::vector<Family> families_of(std::size_t size, const StepRecord& step, const std::vector<std::size_t>& strict) {
    std::vector<std::vector<std::size_t>> children(size);
    std::vector<std::size_t> taken(size, 1);
    for (std::size_t child = 0; child < step.parent.size(); ++child) {
        const std::size_t parent = step.parent[child];
        children[parent].push_back(child);
        taken[parent] = std::min(strict[child], size - parent);
    }
    std::vector<Family> families;
    for (std::size_t module = 0; module < size;) {
        Family family{.first = module, .size = taken[module], .children = children[module]};
        for (std::size_t later = module + 1; later < module + family.size; ++later)
            family.children.insert(family.children.end(), children[later].begin(), children[later].end());
        module += family.size;
        families.push_back(std::move(family));
    }
    return families;
}

} // namespace

StrictSizes strict_sizes(std::span<const StepRecord> steps, const PointGrammar& grammar) {
    StrictSizes strict;
    for (const StepRecord& step : steps) {
        std::vector<std::size_t>& row = strict.emplace_back();
        for (const std::optional<std::uint32_t>& rule : step.rule)
            row.push_back(rule ? grammar.rules[*rule].predecessor.size() : 1);
    }
    return strict;
}

TreeLayout tree_layout(std::span<const std::size_t> sizes, std::span<const StepRecord> steps,
                       const StrictSizes& strict) {
    std::vector<std::vector<Family>> families;
    for (std::size_t row = 0; row < steps.size(); ++row)
        families.push_back(families_of(sizes[row], steps[row], strict[row]));
    std::vector<std::vector<double>> width;
    for (const std::size_t size : sizes) width.emplace_back(size, 1.0);
    for (std::size_t row = steps.size(); row-- > 0;)
        for (Family& family : families[row]) {
            for (const std::size_t child : family.children) family.children_width += width[row + 1][child];
            family.width = std::max(static_cast<double>(family.size), family.children_width);
            for (std::size_t i = 0; i < family.size; ++i)
                width[row][family.first + i] = family.width / static_cast<double>(family.size);
        }
    TreeLayout layout;
    for (const std::size_t size : sizes) layout.centre.emplace_back(size, 0.0);
    for (std::size_t module = 0; module < sizes.front(); ++module) {
        layout.centre.front()[module] = layout.width + width.front()[module] / 2;
        layout.width += width.front()[module];
    }
    for (std::size_t row = 0; row < steps.size(); ++row)
        for (const Family& family : families[row]) {
            const double left = layout.centre[row][family.first] - width[row][family.first] / 2;
            double place = left + (family.width - family.children_width) / 2;
            for (const std::size_t child : family.children) {
                layout.centre[row + 1][child] = place + width[row + 1][child] / 2;
                place += width[row + 1][child];
            }
        }
    return layout;
}

} // namespace internode
