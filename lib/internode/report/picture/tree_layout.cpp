// SPDX-License-Identifier: MIT
//
// Two passes over the rows. From the last word up, each family learns the width of its children and each module its
// share. From the axiom down, the children of a family are set side by side, centred below it.

#include "internode/report/picture/tree_layout.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// How the modules of one word belong together, and how wide what became of them is.
struct Families {
    std::vector<std::size_t> leader;  ///< the first module of each module's family
    std::vector<std::size_t> members; ///< how many modules a family has, at its leader
    std::vector<double> below;        ///< width of a family's children together, at its leader
};

/// A strict predecessor across the seam of a ring ends at the seam here.
Families families_of(std::size_t size, const StepRecord& step, const std::vector<std::size_t>& strict) {
    assert(strict.size() == step.parent.size());
    std::vector<std::size_t> taken(size, 1);
    for (std::size_t child = 0; child < step.parent.size(); ++child) {
        assert(step.parent[child] < size && strict[child] > 0);
        taken[step.parent[child]] = std::min(strict[child], size - step.parent[child]);
    }
    Families families{.leader = std::vector<std::size_t>(size),
                      .members = std::vector<std::size_t>(size, 0),
                      .below = std::vector<double>(size, 0.0)};
    for (std::size_t module = 0; module < size;) {
        const std::size_t first = module;
        families.members[first] = taken[first];
        for (; module < first + taken[first]; ++module) families.leader[module] = first;
    }
    return families;
}

/// The widths of a word's modules, from those of the next word: a family shares the wider of the two rows.
std::vector<double> shared_widths(Families& families, const StepRecord& step, const std::vector<double>& next) {
    assert(next.size() == step.parent.size());
    for (std::size_t child = 0; child < next.size(); ++child)
        families.below[families.leader[step.parent[child]]] += next[child];
    std::vector<double> widths;
    for (const std::size_t first : families.leader) {
        const auto members = static_cast<double>(families.members[first]);
        widths.push_back(std::max(members, families.below[first]) / members);
    }
    return widths;
}

/// Where the first child of each family begins, at its leader.
std::vector<double> first_places(const Families& families, const std::vector<double>& centre,
                                 const std::vector<double>& width) {
    std::vector<double> places(centre.size(), 0.0);
    for (const std::size_t first : families.leader) {
        const double left = centre[first] - width[first] / 2;
        const double all = std::max(static_cast<double>(families.members[first]), families.below[first]);
        places[first] = left + (all - families.below[first]) / 2;
    }
    return places;
}

/// The centres of the next word's modules, family by family from its first place on.
std::vector<double> child_centres(const Families& families, const StepRecord& step, std::vector<double> places,
                                  const std::vector<double>& width) {
    std::vector<double> centres;
    for (std::size_t child = 0; child < width.size(); ++child) {
        double& begin = places[families.leader[step.parent[child]]];
        centres.push_back(begin + width[child] / 2);
        begin += width[child];
    }
    return centres;
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
    assert(sizes.size() == steps.size() + 1 && strict.size() == steps.size());
    std::vector<Families> families;
    for (std::size_t row = 0; row < steps.size(); ++row)
        families.push_back(families_of(sizes[row], steps[row], strict[row]));
    std::vector<std::vector<double>> width(sizes.size());
    width.back().assign(sizes.back(), 1.0);
    for (std::size_t row = steps.size(); row-- > 0;)
        width[row] = shared_widths(families[row], steps[row], width[row + 1]);

    TreeLayout layout;
    for (const std::size_t size : sizes) layout.centre.emplace_back(size, 0.0);
    for (std::size_t module = 0; module < sizes.front(); ++module) {
        layout.centre.front()[module] = layout.width + width.front()[module] / 2;
        layout.width += width.front()[module];
    }
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const std::vector<double> places = first_places(families[row], layout.centre[row], width[row]);
        layout.centre[row + 1] = child_centres(families[row], steps[row], places, width[row + 1]);
    }
    return layout;
}

} // namespace internode
