// SPDX-License-Identifier: MIT
//
// How often a reader or writer asks whether it should stop.

#pragma once

#include <atomic>

namespace internode::tests {

inline std::atomic<int> questions{0};

inline bool stop_at_third_question() {
    return ++questions >= 3;
}

} // namespace internode::tests
