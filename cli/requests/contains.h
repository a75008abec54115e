// SPDX-License-Identifier: MIT
//
// Lists of a few names.

#pragma once

#include <algorithm>

namespace internode::cli {

[[nodiscard]] bool contains(const auto& list, const auto& wanted) {
    return std::ranges::find(list, wanted) != list.end();
}

} // namespace internode::cli
