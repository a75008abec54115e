// SPDX-License-Identifier: MIT
//
// What a path given for output means: a descriptor that is open already, a thing to write into, or a name in a folder.

#pragma once

#include "internode/io/file/descriptor.h"

#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace internode {

struct OutputTarget {
    Descriptor direct;          ///< open: write here (standard output, a device, a FIFO)
    bool is_stream = false;     ///< direct and not a regular file: a write can wait for the other side
    std::string folder;         ///< otherwise the target is `name` in this folder, links followed
    std::string name;           ///< at most 255 bytes, no slash
    std::optional<mode_t> mode; ///< the mode of the file that stands there
    uid_t owner = 0;            ///< the owner of the file that stands there
    gid_t group = 0;
    std::optional<FileError> error;
};

/// Looks at `path` and opens what is to be written directly; a FIFO waits for its reader. Nothing is created.
[[nodiscard]] OutputTarget resolve_output(std::string_view path, ShouldStop should_stop);

} // namespace internode
