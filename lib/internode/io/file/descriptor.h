// SPDX-License-Identifier: MIT
//
// A POSIX file descriptor that closes itself, and waiting on it without losing an interruption.
//
// Every descriptor is 3 or above: with a standard stream closed, a file of ours must not become standard output.

#pragma once

#include "internode/io/file/file_error.h"

#include <string>
#include <utility>

namespace internode {

class Descriptor {
public:
    Descriptor() = default;
    /// Takes over an open descriptor, or -1; one below 3 is moved up.
    explicit Descriptor(int fd);
    Descriptor(Descriptor&& other) noexcept
        : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor();

    /// A duplicate of a descriptor that stays open for its owner.
    [[nodiscard]] static Descriptor duplicate(int fd);

    [[nodiscard]] bool is_open() const { return fd_ >= 0; }
    [[nodiscard]] int get() const { return fd_; }
    /// Closes now. Returns errno, 0 when it went well.
    int close();

private:
    int fd_ = -1;
};

[[nodiscard]] bool stops(ShouldStop should_stop);

/// Sleeps until `events` (POLLIN, POLLOUT) are there; false when should_stop said so first. It is asked every 50 ms: a
/// signal that arrives between the question and the sleep costs no more than that.
[[nodiscard]] bool wait_for(const Descriptor& descriptor, short events, ShouldStop should_stop);

/// Sleeps 20 ms; false when should_stop says so.
[[nodiscard]] bool nap(ShouldStop should_stop);

/// What the system says about an error number: "No space left on device".
[[nodiscard]] std::string system_message(int error_number);

} // namespace internode
