// SPDX-License-Identifier: MIT

#include "internode/io/npy.h"

#include "internode/io/file/binary_buffer.h"

#include <cassert>
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

} // namespace

bool write_npy(Sink& sink, const PointsView& points) {
    require_whole_rows(points);
    BinaryBuffer bytes(sink);
    bytes.put(std::string_view(npy_header(points)));
    for (const double coordinate : points.coordinates)
        if (!bytes.put(coordinate).end_element()) return false;
    return bytes.flush();
}

} // namespace internode
