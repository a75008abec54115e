// SPDX-License-Identifier: MIT
//
// What can go wrong with a file, as a value: the reader and the writer of files share it.
//
// Interruption is asked for, never caught: the library installs no signal handler. Whoever has one (the command) gives
// a function that says whether to stop; reading and writing ask it at least ten times a second while they wait.

#pragma once

#include <cstddef>
#include <string>

namespace internode {

struct FileError {
    enum class Kind {
        Missing,     ///< no such file or folder
        Directory,   ///< a folder where a file is meant
        Unreadable,  ///< permission, a socket, an error of the device
        TooLarge,    ///< more bytes than the limit
        NotText,     ///< holds a byte 0; line and column say where
        Unwritable,  ///< the target cannot be made: found before anything is computed
        WriteFailed, ///< disk full, file size limit, error of the device
        BrokenPipe,  ///< the reader of our output has gone
        Interrupted  ///< should_stop said so
    };
    Kind kind = Kind::Unreadable;
    std::string path{};     ///< the path as the user gave it; "<stdin>", "<stdout>" for `-`
    std::string message{};  ///< without the path: "no such file"
    std::size_t line = 0;   ///< from 1; 0 when no place is meant
    std::size_t column = 0; ///< from 1, in code points
};

/// Whether the work should stop now (a signal came). Null: never.
using ShouldStop = bool (*)();

} // namespace internode
