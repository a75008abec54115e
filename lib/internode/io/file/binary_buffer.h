// SPDX-License-Identifier: MIT
//
// Little-endian numbers gathered before they go to a sink, on any machine the same bytes.

#pragma once

#include "internode/io/file/sink.h"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace internode {

class BinaryBuffer {
public:
    explicit BinaryBuffer(Sink& sink)
        : sink_(sink) {}

    template<std::unsigned_integral T>
    BinaryBuffer& put(T value) {
        std::array<char, sizeof(T)> little{}; // compilers make one store of the loop
        for (std::size_t i = 0; i < sizeof(T); ++i)
            little[i] = static_cast<char>((std::uint64_t{value} >> (8 * i)) & 0xFFU);
        bytes_.append(little.data(), little.size());
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
