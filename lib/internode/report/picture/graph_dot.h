// SPDX-License-Identifier: MIT
//
// The decomposition graph in the language of Graphviz: a node per word, persistent words blue (Nivoliers et al. 2012,
// Fig. 3), an arc for each factor of the image. An arc that occurs several times carries its count.

#pragma once

#include "internode/report/generator.h"
#include "internode/word/factors.h"

#include <string>

namespace internode {

/// The whole DOT text, for any number of words.
[[nodiscard]] std::string graph_dot(const FactorGraph& graph, const Alphabet& alphabet, const Generator& generator);

struct CountedArc {
    std::uint32_t target = 0;
    std::size_t count = 0;
};

/// The arcs of a vertex, each target once, in order of first appearance.
[[nodiscard]] std::vector<CountedArc> counted_arcs(const std::vector<std::uint32_t>& arcs);

} // namespace internode
