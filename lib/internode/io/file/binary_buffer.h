// SPDX-License-Identifier: MIT
//
// Little-endian numbers gathered before they go to a sink, on any machine the same bytes.

#pragma once

#include "internode/io/file/sink.h"

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace internode {

class BinaryBuffer {
public:
    explicit BinaryBuffer(Sink& sink)
        : sink_(sink) {}

    template<std::unsigned_integral T>
    BinaryBuffer& put(T value) {
        for (unsigned shift = 0; shift < 8 * sizeof(T); shift += 8)
            bytes_ += static_cast<char>((std::uint64_t{value} >> shift) & 0xFFU);
        return *this;
    }
    BinaryBuffer& put(double value) { return put(std::bit_cast<std::uint64_t>(value)); }
    BinaryBuffer& put(float value) { return put(std::bit_cast<std::uint32_t>(value)); }
    BinaryBuffer& put(std::string_view text) {
        bytes_ += text;
        return *this;
    }

    /// At the end of an element: passes the bytes on when there are enough. False once the sink has failed.
    bool end_element() {
        constexpr std::size_t enough = std::size_t{1} << 16;
        return bytes_.size() < enough || flush();
    }

    bool flush() {
        const bool good = sink_.write(bytes_);
        bytes_.clear();
        return good;
    }

private:
    Sink& sink_;
    std::string bytes_;
};

} // namespace internode
