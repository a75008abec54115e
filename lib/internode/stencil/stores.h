// SPDX-License-Identifier: MIT
//
// How new points are written.

#pragma once

namespace internode {

/// Which stores write the points; the results are the same. Which are faster depends on the machine, on the size of
/// the result, and on whether its memory was written before.
enum class Stores {
    Measured, ///< a large result by those that were faster over its first stretches, a small one by ordinary stores
    Cached,   ///< ordinary stores, which read a line of the caches before they write it
    Streamed  ///< whole lines past the caches
};

} // namespace internode
