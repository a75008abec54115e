// SPDX-License-Identifier: MIT
//
// A text file read whole, or the reason why not.
//
// Nothing the path can name makes this hang or eat memory: a folder, a socket, /dev/zero, a sparse file of terabytes, a
// FIFO that nobody writes to. A regular file beyond the limit is refused by its size, unread; a byte 0 ends the reading
// of a text (no text format of ours has one), so that endless zeros end with the first chunk.

#pragma once

#include "internode/io/file/file_error.h"
#include "internode/io/file/limits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace internode {

struct InputText {
    std::string text;               ///< the whole content; empty when error is set
    std::string source;             ///< the name for diagnostics: the path, "<stdin>" for `-`
    std::optional<FileError> error; ///< Missing, Directory, Unreadable, TooLarge, NotText or Interrupted
};

struct InputOptions {
    std::uint64_t max_bytes = max_file_bytes; ///< at most so many bytes are accepted
    bool may_be_binary = false;               ///< a byte 0 is a byte like others
    ShouldStop should_stop = nullptr;
};

/// Reads `path`, or standard input for `-`. Memory: the text, and at most as much again while a pipe is read.
[[nodiscard]] InputText read_input(std::string_view path, const InputOptions& options = {});

} // namespace internode
