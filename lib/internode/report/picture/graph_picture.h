// SPDX-License-Identifier: MIT
//
// The decomposition graph as a picture: words on a circle, persistent ones blue (Nivoliers et al. 2012, Fig. 3), an
// arrow to every factor of the image.
//
// The circle is the smallest on which no two words touch; arrows bow inwards so that they pass no word in between.

#pragma once

#include "internode/report/generator.h"
#include "internode/word/factors.h"

#include <string>

namespace internode {

/// More words than a circle can show: use graph_dot (report/picture/graph_dot.h) and Graphviz.
inline constexpr std::size_t max_drawn_words = 64;

/// An SVG file. \throw std::length_error for more than max_drawn_words words, std::invalid_argument for none
[[nodiscard]] std::string graph_picture(const FactorGraph& graph, const Alphabet& alphabet, const std::string& title,
                                        const Generator& generator);

} // namespace internode
