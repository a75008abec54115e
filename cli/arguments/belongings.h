// SPDX-License-Identifier: MIT
//
// The belongings that several options share, and the texts that go with them.

#pragma once

#include "cli/requests/belonging.h"

#include <string>

namespace internode::cli {

/// Options that describe a polygon, by what they are about.
struct PolygonBelongings {
    Belonging degree;
    Belonging word;
    Belonging repeat;
    Belonging ends;
    Belonging weights;
    Belonging element;
    Belonging max_points;
};

/// To interval grammars alone; `hint` is for those who have a point grammar.
[[nodiscard]] Belonging for_intervals(const std::string& hint);

/// To point grammars alone, but never beside the options `without`.
[[nodiscard]] Belonging for_points(std::vector<std::string> without = {});

/// To curves of interval grammars, as for_intervals(); grids refuse the option, called by that name.
[[nodiscard]] Belonging for_curves(const std::string& hint, const std::string& name);

/// To grids alone; others are told that only a grid has `what`.
[[nodiscard]] Belonging for_grids(const std::string& what);

/// The usual hint for those who have a point grammar.
[[nodiscard]] std::string rules_say_everything();

} // namespace internode::cli
