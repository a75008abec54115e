// SPDX-License-Identifier: MIT
//
// The levels of a point grammar's derivation side by side, as the papers draw them (S0, figures 1, 7 and 11; S1, figure
// 2). Each has a panel: its polygon in a thin line with its points as dots, over the control polygon in grey.
//
// Where a word has lines of its own (S1, equation 9), they are drawn instead of the polygon. All panels have one scale;
// points of one coordinate are drawn over their numbers, at equal steps. The words of several polygons stand together
// in the panel of their level.

#pragma once

#include "internode/point/strands.h"
#include "internode/report/generator.h"
#include "internode/report/picture/planar_curve.h"

#include <cstddef>
#include <string>
#include <vector>

namespace internode {

/// Panels of one picture.
inline constexpr std::size_t max_level_panels = 12;

struct PictureLevel {
    std::size_t number = 0;            ///< cycles
    std::vector<PointStrands> parts{}; ///< the drawing of each word, after the interpretation
};

struct LevelsPicture {
    std::vector<PictureLevel> levels{}; ///< levels in their order
    bool has_control = true;            ///< the first level is a control polygon, and lies under the others
    PictureAxes axes{};                 ///< axes of points with more than one coordinate
    std::string title{};
    Generator generator{};
};

/// An SVG text, 960 pixels wide. \throw std::invalid_argument for no level, more than max_level_panels, an axis that
/// some points do not have, levels without any point, and numbers beside points
/// of more coordinates
[[nodiscard]] std::string levels_picture(const LevelsPicture& picture);

} // namespace internode
