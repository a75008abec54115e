// SPDX-License-Identifier: MIT

#include "internode/report/picture/graph_dot.h"

#include "internode/report/markup.h"

#include <algorithm>
#include <cassert>

namespace internode {

std::vector<CountedArc> counted_arcs(const std::vector<std::uint32_t>& arcs) {
    std::vector<CountedArc> counted;
    for (const std::uint32_t target : arcs) {
        const auto known = std::ranges::find(counted, target, &CountedArc::target);
        if (known != counted.end())
            ++known->count;
        else
            counted.push_back({.target = target, .count = 1});
    }
    return counted;
}

std::string graph_dot(const FactorGraph& graph, const Alphabet& alphabet, const Generator& generator) {
    assert(graph.arcs.size() == graph.words.size() && graph.persistent.size() == graph.words.size());
    std::string text = "digraph decompositions {\n";
    text += "    comment=" + dot_quoted("internode " + generator.version + ": " + generator.command) + ";\n";
    text += "    node [shape=box, style=\"rounded,filled\", fontname=\"Helvetica\", color=\"#777777\", "
            "fillcolor=\"#ffffff\"];\n";
    text += "    edge [color=\"#777777\"];\n";
    for (std::size_t v = 0; v < graph.words.size(); ++v) {
        text += "    w" + std::to_string(v) + " [label=" + dot_quoted(to_string(graph.words[v], alphabet));
        if (graph.persistent[v]) text += ", color=\"#0077bb\", fillcolor=\"#d6ebf8\"";
        text += "];\n";
    }
    for (std::size_t v = 0; v < graph.words.size(); ++v) {
        for (const CountedArc& arc : counted_arcs(graph.arcs[v])) {
            text += "    w" + std::to_string(v) + " -> w" + std::to_string(arc.target);
            if (arc.count > 1) text += " [label=\"×" + std::to_string(arc.count) + "\"]";
            text += ";\n";
        }
    }
    text += "}\n";
    return text;
}

} // namespace internode
