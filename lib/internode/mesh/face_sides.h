// SPDX-License-Identifier: MIT
//
// The sides of faces, and which of them meet. Side c goes from corner c of FaceList::corners() to the next one of its
// face.

#pragma once

#include "internode/mesh/face_list.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace internode {

/// More corners than this, or vertices, are refused: indices keep a bit to spare.
inline constexpr std::size_t most_half_edges = (std::size_t{1} << 31U) - 1;

struct FaceSide {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t side;
    std::uint32_t face;

    [[nodiscard]] std::array<std::uint32_t, 2> edge() const { return {std::min(from, to), std::max(from, to)}; }
};

/// Those of the faces that are not left out, by their edges and then in the order of the faces; `left_out` has an entry
/// for each face, or none. At most most_half_edges corners.
[[nodiscard]] std::vector<FaceSide> sides_by_edge(const FaceList& faces, const std::vector<bool>& left_out = {});

/// Calls visit(sides) for each edge with its sides.
template<typename Visit>
void for_each_edge(std::span<const FaceSide> sides, Visit visit) {
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first;
        while (last < sides.size() && sides[last].edge() == sides[first].edge()) ++last;
        visit(sides.subspan(first, last - first));
        first = last;
    }
}

inline constexpr std::uint32_t no_side = 0xFFFFFFFF;

/// Faces that hang together by sides joined in pairs.
class JoinedFaces {
public:
    /// No side is joined yet. The faces must outlive this.
    explicit JoinedFaces(const FaceList& faces);

    void join(std::uint32_t a, std::uint32_t b) {
        twin_[a] = b;
        twin_[b] = a;
    }
    /// The side across the edge, or no_side.
    [[nodiscard]] std::uint32_t twin(std::uint32_t side) const { return twin_[side]; }
    [[nodiscard]] std::uint32_t face(std::uint32_t side) const { return face_[side]; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t side) const { return faces_.corners()[side]; }
    [[nodiscard]] std::uint32_t next(std::uint32_t side) const {
        const std::size_t face = face_[side];
        return static_cast<std::uint32_t>(side + std::size_t{1} < faces_.first(face + 1) ? side + std::size_t{1}
                                                                                         : faces_.first(face));
    }
    [[nodiscard]] std::uint32_t previous(std::uint32_t side) const {
        const std::size_t face = face_[side];
        return static_cast<std::uint32_t>((side > faces_.first(face) ? side : faces_.first(face + 1)) - 1);
    }
    [[nodiscard]] std::size_t side_count() const { return twin_.size(); }
    /// How many faces follow one another round the origin of a side, by joined sides, that one included.
    [[nodiscard]] std::size_t fan_size(std::uint32_t side) const;

private:
    const FaceList& faces_;
    std::vector<std::uint32_t> face_;
    std::vector<std::uint32_t> twin_;
};

/// The faces of a manifold joined along every edge of two.
[[nodiscard]] JoinedFaces joined_faces(const FaceList& faces);

} // namespace internode
