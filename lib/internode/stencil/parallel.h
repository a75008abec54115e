// SPDX-License-Identifier: MIT
//
// Independent tasks on several threads; the only place, with its source, that knows oneTBB.

#pragma once

#include <cstddef>
#include <functional>

namespace internode {

/// task(0) … task(count - 1), each once, on at most `threads` threads (0: all that oneTBB has), in any order; on one
/// thread in their order. The first exception of a task is thrown again here.
void for_each_task(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

} // namespace internode
