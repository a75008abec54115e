// SPDX-License-Identifier: MIT
//
// One state per cell, in 1, 2 or 4 bytes, as few as the automaton's states need.

#pragma once

#include "internode/stencil/fused_stencils.h"

#include <cstdint>
#include <variant>
#include <vector>

namespace internode {

class CellArray {
public:
    CellArray(const std::vector<std::uint32_t>& states, std::size_t state_count);

    /// The cells after the steps of the table; `count` of them.
    [[nodiscard]] CellArray refined(const FusedStencils& stencils, std::uint64_t count) const;

    [[nodiscard]] std::size_t size() const;
    /// 1, 2 or 4.
    [[nodiscard]] std::size_t bytes_per_cell() const;

    /// visitor(const T* states) with T of 1, 2 or 4 bytes.
    template<typename Visitor>
    decltype(auto) visit(Visitor&& visitor) const {
        return std::visit([&](const auto& states) -> decltype(auto) { return visitor(states.data()); }, states_);
    }

    /// Bytes of a state of an automaton with so many.
    [[nodiscard]] static std::size_t bytes_for(std::size_t state_count);

private:
    CellArray() = default;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<std::uint32_t>> states_;
};

} // namespace internode
