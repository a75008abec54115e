// SPDX-License-Identifier: MIT
//
// Faces as rings of corners, one behind the other: triangles, quadrilaterals and polygons alike.

#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace internode {

class FaceList {
public:
    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
    /// The vertices of a face's corners.
    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t face) const {
        assert(face < size());
        return std::span(corners_).subspan(first_[face], first_[face + 1] - first_[face]);
    }
    /// The corners of all faces.
    [[nodiscard]] std::span<const std::uint32_t> corners() const { return corners_; }
    /// Where in corners() a face begins; of size(), where the last one ends.
    [[nodiscard]] std::size_t first(std::size_t face) const { return first_[face]; }

    void add(std::span<const std::uint32_t> corners) {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        first_.push_back(corners_.size());
    }

    friend bool operator==(const FaceList&, const FaceList&) = default;

private:
    std::vector<std::size_t> first_{0};
    std::vector<std::uint32_t> corners_;
};

/// Each set of corners that several faces have, with these, ascending; of the faces that are not left out, an entry for
/// each face.
struct FaceCopies {
    std::vector<std::uint32_t> corners; ///< ascending
    std::vector<std::size_t> faces;
};
[[nodiscard]] std::vector<FaceCopies> copies_of_faces(const FaceList& faces, const std::vector<bool>& left_out);

/// Three corners a face. \throw std::invalid_argument for corners that are not threes
[[nodiscard]] FaceList triangles(std::span<const std::uint32_t> corners);

} // namespace internode
