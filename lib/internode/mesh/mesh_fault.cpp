// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_fault.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

constexpr std::size_t most_half_edges = (std::size_t{1} << 31U) - 1;

using Corners = std::array<std::uint32_t, 3>;

/// "3 7".
template<typename Numbers>
std::string listed(const Numbers& numbers, const char* between) {
    std::string text;
    for (const auto number : numbers) text += (text.empty() ? "" : between) + std::to_string(number);
    return text;
}

/// A passage of a face from one corner to the next.
struct Passage {
    std::uint32_t from;
    std::uint32_t to;
    std::size_t face;

    [[nodiscard]] std::array<std::uint32_t, 2> edge() const { return {std::min(from, to), std::max(from, to)}; }
};

class FaultFinder {
public:
    FaultFinder(std::size_t vertex_count, std::span<const std::uint32_t> corners)
        : vertex_count_(vertex_count)
        , corners_(corners) {}

    [[nodiscard]] std::vector<MeshFault> find() && {
        if (corners_.size() > most_half_edges || vertex_count_ > most_half_edges)
            return {{MeshFaultKind::TooLarge, {}, {}}};
        find_bad_corners();
        if (!faults_.empty()) return std::move(faults_);
        find_duplicate_faces();
        find_bad_edges();
        if (faults_.empty()) find_bad_vertices(); // fans need edges of two faces
        return std::move(faults_);
    }

private:
    [[nodiscard]] std::size_t face_count() const { return corners_.size() / 3; }
    [[nodiscard]] Corners corners(std::size_t face) const {
        return {corners_[3 * face], corners_[3 * face + 1], corners_[3 * face + 2]};
    }

    void find_bad_corners() {
        for (std::size_t face = 0; face < face_count(); ++face) {
            const auto [a, b, c] = corners(face);
            for (const std::uint32_t corner : {a, b, c})
                if (corner >= vertex_count_) faults_.push_back({MeshFaultKind::IndexOutOfRange, {corner}, {face}});
            if (a == b || b == c || c == a) faults_.push_back({MeshFaultKind::DegenerateFace, {a, b, c}, {face}});
        }
    }

    void find_duplicate_faces() {
        std::vector<std::pair<Corners, std::size_t>> sorted;
        sorted.reserve(face_count());
        for (std::size_t face = 0; face < face_count(); ++face) {
            Corners key = corners(face);
            std::ranges::sort(key);
            sorted.emplace_back(key, face);
        }
        std::ranges::sort(sorted);
        for (std::size_t first = 0; first < sorted.size();) {
            MeshFault fault{MeshFaultKind::DuplicateFace, {sorted[first].first.begin(), sorted[first].first.end()}, {}};
            std::size_t last = first;
            for (; last < sorted.size() && sorted[last].first == sorted[first].first; ++last)
                fault.faces.push_back(sorted[last].second);
            if (last - first > 1) faults_.push_back(std::move(fault));
            first = last;
        }
    }

    void find_bad_edges() {
        std::vector<Passage> passages;
        passages.reserve(corners_.size());
        for (std::size_t face = 0; face < face_count(); ++face) {
            const Corners corner = corners(face);
            for (std::size_t i = 0; i < 3; ++i) passages.push_back({corner[i], corner[(i + 1) % 3], face});
        }
        std::ranges::stable_sort(passages, {}, &Passage::edge);
        for (std::size_t first = 0; first < passages.size();) {
            std::size_t last = first;
            while (last < passages.size() && passages[last].edge() == passages[first].edge()) ++last;
            check_edge(std::span(passages).subspan(first, last - first));
            first = last;
        }
    }

    void check_edge(std::span<const Passage> passages) {
        const bool same_way = passages.size() == 2 && passages[0].from == passages[1].from;
        if (passages.size() < 2 || (passages.size() == 2 && !same_way)) return;
        const auto [a, b] = passages.front().edge();
        MeshFault fault{same_way ? MeshFaultKind::Orientation : MeshFaultKind::NonManifoldEdge, {a, b}, {}};
        for (const Passage& passage : passages) fault.faces.push_back(passage.face);
        faults_.push_back(std::move(fault));
    }

    /// The faces at a vertex hang together by edges at it, or there are fans.
    void find_bad_vertices() {
        std::vector<std::vector<std::size_t>> faces_at(vertex_count_);
        for (std::size_t face = 0; face < face_count(); ++face)
            for (const std::uint32_t corner : corners(face)) faces_at[corner].push_back(face);
        for (std::size_t vertex = 0; vertex < vertex_count_; ++vertex) {
            const auto name = static_cast<std::uint32_t>(vertex);
            if (faces_at[vertex].empty()) faults_.push_back({MeshFaultKind::IsolatedVertex, {name}, {}});
            if (fan_count(name, faces_at[vertex]) > 1)
                faults_.push_back({MeshFaultKind::NonManifoldVertex, {name}, faces_at[vertex]});
        }
    }

    /// Each face at the vertex goes in by one neighbour and out by another: fans are the chains and rings of these.
    [[nodiscard]] std::size_t fan_count(std::uint32_t vertex, const std::vector<std::size_t>& faces) const {
        std::map<std::uint32_t, std::uint32_t> after;
        std::map<std::uint32_t, std::uint32_t> before;
        for (const std::size_t face : faces) {
            const Corners corner = corners(face);
            const auto at = static_cast<std::size_t>(std::ranges::find(corner, vertex) - corner.begin());
            after.emplace(corner[(at + 1) % 3], corner[(at + 2) % 3]);
            before.emplace(corner[(at + 2) % 3], corner[(at + 1) % 3]);
        }
        std::size_t fans = 0;
        while (!after.empty()) {
            ++fans;
            std::uint32_t neighbour = after.begin()->first;
            while (before.contains(neighbour) && before.at(neighbour) != after.begin()->first)
                neighbour = before.at(neighbour);
            for (auto found = after.find(neighbour); found != after.end(); found = after.find(neighbour)) {
                neighbour = found->second;
                before.erase(neighbour);
                after.erase(found);
            }
        }
        return fans;
    }

    std::size_t vertex_count_;
    std::span<const std::uint32_t> corners_;
    std::vector<MeshFault> faults_;
};

} // namespace

std::string description(const MeshFault& fault) {
    const std::string vertices = listed(fault.vertices, " ");
    const std::string faces = listed(fault.faces, ", ");
    switch (fault.kind) {
    case MeshFaultKind::TooLarge:
        return "more than " + std::to_string(most_half_edges) + " vertices or corners of faces, the limit";
    case MeshFaultKind::IndexOutOfRange:
        return "face " + faces + " has a corner " + vertices + ", and no vertex has that number";
    case MeshFaultKind::DegenerateFace:
        return "face " + faces + " has a corner twice: " + vertices;
    case MeshFaultKind::DuplicateFace:
        return "faces " + faces + " have the same corners " + vertices;
    case MeshFaultKind::Orientation:
        return "faces " + faces + " pass the edge " + vertices + " in the same direction";
    case MeshFaultKind::NonManifoldEdge:
        return "the edge " + vertices + " has " + std::to_string(fault.faces.size()) + " faces: " + faces;
    case MeshFaultKind::NonManifoldVertex:
        return "the faces at vertex " + vertices + " are more than one fan: " + faces;
    case MeshFaultKind::IsolatedVertex:
        return "vertex " + vertices + " has no face";
    }
    return {};
}

std::vector<MeshFault> mesh_faults(std::size_t vertex_count, std::span<const std::uint32_t> corners) {
    if (corners.size() % 3 != 0) throw std::invalid_argument("corners of triangles come in threes");
    return FaultFinder(vertex_count, corners).find();
}

} // namespace internode
