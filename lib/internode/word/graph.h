// SPDX-License-Identifier: MIT
//
// The graph G(M) of a system (Nivoliers et al. 2012, Definition 3.4): a node per symbol, an arc i -> j when m_ij > 0.
// Its strongly connected classes carry the whole question of validity: *final* classes have no arc that leaves them.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace internode {

/// Successors of each node; repetitions are allowed and mean nothing here.
using Graph = std::vector<std::vector<std::uint32_t>>;

struct StrongComponents {
    std::vector<std::uint32_t> component; ///< the component of each node
    std::vector<std::vector<std::uint32_t>>
        members;              ///< the nodes of each component, ascending; components that arcs lead to come first
    std::vector<bool> final;  ///< whether no arc leaves the component
    std::vector<bool> cyclic; ///< whether each component has more than one node, or a loop
};

/// Tarjan's algorithm, without recursion: linear in nodes and arcs.
[[nodiscard]] StrongComponents strong_components(const Graph& graph);

/// The period of a cyclic component: the greatest common divisor of the lengths of its cycles; 0 if not cyclic.
[[nodiscard]] std::size_t period(const Graph& graph, const StrongComponents& components, std::size_t component);

/// All nodes reachable from `start`, start included.
[[nodiscard]] std::vector<bool> reachable(const Graph& graph, const std::vector<std::uint32_t>& start);

} // namespace internode
