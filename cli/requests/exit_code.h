// SPDX-License-Identifier: MIT
//
// What the command says to the shell. 1 comes only from `validate` and `mesh`: a verdict, not an error.

#pragma once

#include <stdexcept>
#include <string>

namespace internode::cli {

enum class ExitCode : int {
    Success = 0,
    NotValid = 1,     ///< `validate`: invalid or undecided; `mesh`: no manifold, or not oriented
    Usage = 2,        ///< unknown option, missing argument, option out of range
    Refused = 3,      ///< text or data refused, limits included; an invalid grammar given to another command
    File = 4,         ///< missing, unreadable or unwritable file
    Bug = 5,          ///< ours
    Interrupted = 130 ///< SIGINT
};

/// Ends a command: `what()` goes to stderr as it stands, with its final newline.
class Failure : public std::runtime_error {
public:
    Failure(ExitCode code, const std::string& text)
        : std::runtime_error(text)
        , code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// `error: message`, and `hint: …` on a line of its own when there is one; what a user typed may stand in both, and
/// reaches the terminal escaped.
[[nodiscard]] Failure failure(ExitCode code, const std::string& message, const std::string& hint = {});

} // namespace internode::cli
