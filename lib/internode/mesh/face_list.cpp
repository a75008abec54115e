// SPDX-License-Identifier: MIT

#include "internode/mesh/face_list.h"

#include <algorithm>
#include <stdexcept>

namespace internode {

std::vector<FaceCopies> copies_of_faces(const FaceList& faces, const std::vector<bool>& left_out) {
    FaceList sorted; // each with its corners ascending
    std::vector<std::size_t> order;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        std::vector<std::uint32_t> corners(faces[face].begin(), faces[face].end());
        std::ranges::sort(corners);
        sorted.add(corners);
        if (!left_out[face]) order.push_back(face);
    }
    std::ranges::stable_sort(order, [&sorted](std::size_t a, std::size_t b) {
        return std::ranges::lexicographical_compare(sorted[a], sorted[b]);
    });
    std::vector<FaceCopies> all;
    for (std::size_t first = 0; first < order.size();) {
        const std::span<const std::uint32_t> corners = sorted[order[first]];
        std::size_t last = first + 1;
        while (last < order.size() && std::ranges::equal(corners, sorted[order[last]])) ++last;
        const std::span<const std::size_t> same = std::span(order).subspan(first, last - first);
        if (same.size() > 1) all.push_back({{corners.begin(), corners.end()}, {same.begin(), same.end()}});
        first = last;
    }
    return all;
}

FaceList triangles(std::span<const std::uint32_t> corners) {
    if (corners.size() % 3 != 0) throw std::invalid_argument("corners of triangles come in threes");
    FaceList faces;
    for (std::size_t first = 0; first < corners.size(); first += 3) faces.add(corners.subspan(first, 3));
    return faces;
}

} // namespace internode
