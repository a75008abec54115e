// SPDX-License-Identifier: MIT
//
// What this library is and what it stands on.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// "0.1.0".
[[nodiscard]] std::string_view version();

/// The instruction set that the code outside the kernels (stencil/kernel.h) was compiled for: "x86-64", "x86-64 with
/// AVX2", "other". Results do not depend on it.
[[nodiscard]] std::string_view instruction_set();

struct LibraryVersion {
    std::string name;
    std::string version;
};

/// The libraries compiled in, in alphabetical order.
[[nodiscard]] std::vector<LibraryVersion> library_versions();

} // namespace internode
