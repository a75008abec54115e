// SPDX-License-Identifier: MIT
//
// What the command does with signals; the library has none.
//
// SIGINT ends the process at once with 130: outputs are renamed into place only when whole, so all there is to do is to
// remove the temporary file that is being written. SIGPIPE and SIGXFSZ are ignored: their cases arrive as failed
// writes.

#pragma once

#include <string_view>

namespace internode::cli {

void install_signal_handlers();

/// Removes this file when the process is interrupted, until forget() is called for it. At most four at a time; a path
/// that is empty or too long is left out.
void remove_on_interrupt(std::string_view path);
void forget(std::string_view path);

} // namespace internode::cli
