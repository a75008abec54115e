// SPDX-License-Identifier: MIT
//
// Strong components by Tarjan's algorithm: the stack of open nodes holds a component as soon as its root is left. The
// period is the greatest common divisor of what the arcs of a component add to distances from one of its nodes.

#include "internode/word/graph.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace internode {

namespace {

constexpr std::uint32_t unseen = 0xffffffff;

/// Tarjan's algorithm with a stack of its own: a path of 10^6 nodes is a legal graph.
class Tarjan {
public:
    explicit Tarjan(const Graph& graph)
        : graph_(graph)
        , order_(graph.size(), unseen)
        , low_(graph.size(), unseen) {
        result_.component.assign(graph.size(), unseen);
        for (std::uint32_t node = 0; node < graph.size(); ++node)
            if (order_[node] == unseen) visit(node);
    }

    StrongComponents take() { return std::move(result_); }

private:
    struct Call {
        std::uint32_t node;
        std::size_t next; ///< the arc to follow next
    };

    void enter(std::uint32_t node) {
        order_[node] = low_[node] = time_++;
        open_.push_back(node);
        calls_.push_back({node, 0});
    }

    void visit(std::uint32_t root) {
        enter(root);
        while (!calls_.empty()) {
            Call& call = calls_.back();
            if (call.next < graph_[call.node].size())
                follow(call.node, graph_[call.node][call.next++]);
            else
                leave(call.node);
        }
    }

    void follow(std::uint32_t node, std::uint32_t successor) {
        assert(successor < graph_.size());
        if (order_[successor] == unseen)
            enter(successor);
        else if (result_.component[successor] == unseen)
            low_[node] = std::min(low_[node], order_[successor]);
    }

    void leave(std::uint32_t node) {
        calls_.pop_back();
        if (!calls_.empty()) low_[calls_.back().node] = std::min(low_[calls_.back().node], low_[node]);
        assert(low_[node] <= order_[node]);
        if (low_[node] == order_[node]) close(node);
    }

    void close(std::uint32_t root) {
        const auto component = static_cast<std::uint32_t>(result_.members.size());
        assert(!open_.empty() && component < graph_.size());
        const auto first = std::find(open_.rbegin(), open_.rend(), root).base() - 1;
        std::vector<std::uint32_t> members(first, open_.end());
        open_.erase(first, open_.end());
        std::ranges::sort(members);
        for (const std::uint32_t member : members) result_.component[member] = component;
        result_.members.push_back(std::move(members));
    }

    const Graph& graph_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> low_;
    std::vector<std::uint32_t> open_; ///< nodes whose component is not closed yet
    std::vector<Call> calls_;
    std::uint32_t time_ = 0;
    StrongComponents result_;
};

} // namespace

StrongComponents strong_components(const Graph& graph) {
    StrongComponents result = Tarjan(graph).take();
    assert(std::ranges::find(result.component, unseen) == result.component.end());
    result.final.assign(result.members.size(), true);
    result.cyclic.assign(result.members.size(), false);
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        for (const std::uint32_t successor : graph[node]) {
            if (result.component[successor] == result.component[node])
                result.cyclic[result.component[node]] = true;
            else
                result.final[result.component[node]] = false;
        }
    }
    return result;
}

std::size_t period(const Graph& graph, const StrongComponents& components, std::size_t component) {
    // Every arc u -> v of the component closes walks whose lengths differ by distance(u) + 1 - distance(v).
    assert(components.component.size() == graph.size());
    const std::vector<std::uint32_t>& members = components.members.at(component);
    assert(!members.empty());
    std::vector<std::size_t> distance(graph.size(), unseen);
    std::vector<std::uint32_t> queue{members.front()};
    distance[members.front()] = 0;
    std::size_t divisor = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const std::uint32_t node = queue[head];
        for (const std::uint32_t successor : graph[node]) {
            if (components.component[successor] != component) continue;
            if (distance[successor] == unseen) {
                distance[successor] = distance[node] + 1;
                queue.push_back(successor);
            }
            const std::size_t walk = distance[node] + 1;
            const std::size_t other = distance[successor];
            divisor = std::gcd(divisor, std::max(walk, other) - std::min(walk, other));
        }
    }
    return divisor;
}

std::vector<bool> reachable(const Graph& graph, const std::vector<std::uint32_t>& start) {
    std::vector<bool> reached(graph.size(), false);
    std::vector<std::uint32_t> pending;
    const auto reach = [&](std::uint32_t node) {
        assert(node < reached.size());
        if (reached[node]) return;
        reached[node] = true;
        pending.push_back(node);
    };
    for (const std::uint32_t node : start) reach(node);
    while (!pending.empty()) {
        const std::uint32_t node = pending.back();
        pending.pop_back();
        for (const std::uint32_t successor : graph[node]) reach(successor);
    }
    return reached;
}

} // namespace internode
