// SPDX-License-Identifier: MIT

#include "internode/io/npy.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <string>

namespace internode {

namespace {

/// Magic, version, the length of the dictionary in two bytes, the dictionary padded with blanks and a newline to a
/// multiple of 64 in all (NumPy's format, NEP 1).
std::string npy_header(const PointsView& points) {
    std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(points.size()) +
                             ", " + std::to_string(points.dimension) + "), }";
    constexpr std::size_t preamble = 10;
    constexpr std::size_t alignment = 64;
    const std::size_t unpadded = preamble + dictionary.size() + 1;
    dictionary.append((alignment - unpadded % alignment) % alignment, ' ');
    dictionary += '\n';
    assert(dictionary.size() <= 0xFFFF);
    std::string header("\x93NUMPY\x01\x00", 8);
    header += static_cast<char>(dictionary.size() & 0xFFU);
    header += static_cast<char>(dictionary.size() >> 8U);
    return header + dictionary;
}

void append_little_endian(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xFFU);
}

} // namespace

bool write_npy(Sink& sink, const PointsView& points) {
    require_whole_rows(points);
    bool good = sink.write(npy_header(points));
    constexpr std::size_t chunk = 8192; // doubles
    std::string bytes;
    for (std::size_t i = 0; good && i < points.coordinates.size(); i += chunk) {
        const std::size_t count = std::min(chunk, points.coordinates.size() - i);
        bytes.clear();
        for (const double value : points.coordinates.subspan(i, count)) append_little_endian(bytes, value);
        good = sink.write(bytes);
    }
    return good;
}

} // namespace internode
