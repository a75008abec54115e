// SPDX-License-Identifier: MIT
//
// What targets hold against every input: a broken law ends the process, which the fuzzer reports.

#pragma once

#include <cstdlib>
#include <cstring>
#include <vector>

namespace internode::fuzz {

inline void require(bool holds) {
    if (!holds) std::abort();
}

/// The same doubles bit for bit: signs of zeros count.
inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    // Of an empty vector there may be no address.
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

} // namespace internode::fuzz
