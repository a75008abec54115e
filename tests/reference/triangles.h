// SPDX-License-Identifier: MIT
//
// The slow and obvious mesh: a list of triangles, on which the stellar operators are replacements of corners.

#pragma once

#include "internode/mesh/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace internode::reference {

using Corner = std::uint32_t;
using Triangle = std::array<Corner, 3>;

class Triangles {
public:
    Triangles(std::size_t vertex_count, const std::vector<Corner>& corners)
        : vertex_count_(vertex_count) {
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add({corners[i], corners[i + 1], corners[i + 2]});
    }

    [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Each with its smallest corner first, in their order.
    [[nodiscard]] std::multiset<Triangle> sorted() const { return {triangles_.begin(), triangles_.end()}; }
    [[nodiscard]] std::vector<Corner> corners() const {
        std::vector<Corner> all;
        for (const Triangle& triangle : triangles_) all.insert(all.end(), triangle.begin(), triangle.end());
        return all;
    }
    [[nodiscard]] std::size_t edge_count() const {
        std::set<std::pair<Corner, Corner>> edges;
        for (const Triangle& triangle : triangles_)
            for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
        return edges.size();
    }
    [[nodiscard]] bool is_mesh() const { return mesh_faults(vertex_count_, internode::triangles(corners())).empty(); }

    void split_edge(Corner a, Corner b) {
        const auto m = static_cast<Corner>(vertex_count_++);
        std::vector<Triangle> old;
        old.swap(triangles_);
        for (const Triangle& triangle : old) {
            if (has(triangle, a) && has(triangle, b)) {
                add(replaced(triangle, b, m));
                add(replaced(triangle, a, m));
            } else {
                add(triangle);
            }
        }
    }

    void split_face(const Triangle& face) {
        const auto m = static_cast<Corner>(vertex_count_++);
        std::erase(triangles_, first_smallest(face));
        for (const Corner corner : face) add(replaced(face, corner, m));
    }

    /// Moves m along its edge to b, which is straight on from a: the triangles at m and b vanish.
    void weld_edge(Corner m, Corner b) {
        std::vector<Triangle> old;
        old.swap(triangles_);
        for (const Triangle& triangle : old)
            if (!has(triangle, m) || !has(triangle, b)) add(replaced(triangle, m, b));
        take_last(m);
    }

    void weld_face(Corner m, const Triangle& outer) {
        std::erase_if(triangles_, [m](const Triangle& triangle) { return has(triangle, m); });
        add(outer);
        take_last(m);
    }

    void flip(Corner a, Corner b, Corner c, Corner d) {
        std::erase(triangles_, first_smallest({a, b, c}));
        std::erase(triangles_, first_smallest({b, a, d}));
        add({d, c, a});
        add({c, d, b});
    }

private:
    static bool has(const Triangle& triangle, Corner corner) {
        return std::ranges::find(triangle, corner) != triangle.end();
    }
    static Triangle replaced(Triangle triangle, Corner from, Corner to) {
        std::ranges::replace(triangle, from, to);
        return triangle;
    }
    static Triangle first_smallest(Triangle triangle) {
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        return triangle;
    }
    void add(const Triangle& triangle) { triangles_.push_back(first_smallest(triangle)); }
    /// The last vertex gets the number of one that went.
    void take_last(Corner m) {
        const auto last = static_cast<Corner>(--vertex_count_);
        for (Triangle& triangle : triangles_) triangle = first_smallest(replaced(triangle, last, m));
    }

    std::size_t vertex_count_;
    std::vector<Triangle> triangles_; ///< each with its smallest corner first
};

} // namespace internode::reference
