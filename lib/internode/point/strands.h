// SPDX-License-Identifier: MIT
//
// The points of a word as they are drawn: which are joined, and where a line ends.

#pragma once

#include "internode/point/module_word.h"
#include "internode/point/point_system.h"

#include <cstddef>
#include <vector>

namespace internode {

/// The drawing of a word: the modules with exactly one point are joined along their axes (a branch starts at the point
/// before it, a ring is closed). A module with two points is a line of its own.
struct PointStrands {
    std::size_t dimension = 0;  ///< coordinates of every point; 0 when there is none
    std::vector<double> points; ///< the points of modules with exactly one, in the order of the word
    struct Strand {
        std::vector<std::size_t> points; ///< indices of points, at least one
        bool closed = false;
    };
    std::vector<Strand> strands;
    std::vector<double> lines; ///< pairs of points
    [[nodiscard]] std::size_t size() const { return dimension == 0 ? 0 : points.size() / dimension; }
};

/// `passes`: after how many interpretation passes the word is. Points of several dimensions in one word: those of the
/// first are kept. A branch without points has no strand. Cost: linear.
[[nodiscard]] PointStrands strands(const ModuleWord& word, const PointSystem& system, std::size_t passes);

} // namespace internode
