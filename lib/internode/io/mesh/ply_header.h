// SPDX-License-Identifier: MIT
//
// The header of a PLY file: what its elements are and how their numbers are written (Turk, "The PLY Polygon File
// Format", 1994). Not installed.

#pragma once

#include "internode/text/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a number in a binary file.
[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> count; ///< the type of the number of entries before a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0; ///< where the data begin
    std::size_t lines = 0; ///< lines before them
};

struct ParsedPlyHeader {
    std::optional<PlyHeader> header;
    std::vector<Diagnostic> errors;
};

[[nodiscard]] ParsedPlyHeader read_ply_header(std::string_view bytes, std::string_view source);

} // namespace internode
