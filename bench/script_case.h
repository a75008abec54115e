// SPDX-License-Identifier: MIT
//
// A small curve for peers that are scripts: they read it from files, and internode's time for it is printed.

#pragma once

namespace internode::bench {

/// Writes coarse.f64, points.f64, inserted.f64 and fine.f64, raw doubles, to the folder; prints internode's time of one
/// run in seconds. 0 or an exit code.
int write_script_case(const char* folder);

} // namespace internode::bench
