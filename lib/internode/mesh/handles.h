// SPDX-License-Identifier: MIT
//
// Names of the elements of a mesh. Each kind is a type of its own: a vertex is never taken for an edge.

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace internode {

enum class Vertex : std::uint32_t {};
enum class HalfEdge : std::uint32_t {};
enum class Edge : std::uint32_t {};
enum class Face : std::uint32_t {};

/// Beyond a boundary.
inline constexpr HalfEdge no_half_edge{0xFFFFFFFF};

template<typename T>
concept MeshHandle =
    std::same_as<T, Vertex> || std::same_as<T, HalfEdge> || std::same_as<T, Edge> || std::same_as<T, Face>;

template<MeshHandle Handle>
[[nodiscard]] constexpr std::size_t to_index(Handle handle) {
    return static_cast<std::size_t>(handle);
}

/// The handle of an index below 2^32 - 1.
template<MeshHandle Handle>
[[nodiscard]] constexpr Handle handle_of(std::size_t index) {
    return Handle{static_cast<std::uint32_t>(index)};
}

} // namespace internode
