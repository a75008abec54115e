// SPDX-License-Identifier: MIT
//
// Independent tasks on several threads; the only place, with its source, that knows oneTBB.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace internode {

/// task(0) … task(count - 1), each once, on at most `threads` threads (0: all that oneTBB has), in any order; on one
/// thread in their order. The first exception of a task is thrown again here.
void for_each_task(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

/// take(make(0)), take(make(1)), … take(make(count - 1)): `make` runs on at most `threads` threads as above, a few
/// ahead of `take`, which runs once at a time and in order. Stops where `take` answers false, and is false then. The
/// first exception is thrown again here.
bool for_each_text(std::size_t count, int threads, const std::function<std::string(std::size_t)>& make,
                   const std::function<bool(std::string_view)>& take);

} // namespace internode
