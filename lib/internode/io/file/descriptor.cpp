// SPDX-License-Identifier: MIT

#include "internode/io/file/descriptor.h"

#include <cassert>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace internode {

Descriptor::Descriptor(int fd)
    : fd_(fd) {
    if (fd < 0 || fd > STDERR_FILENO) return;
    fd_ = ::fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int error_number = errno;
    ::close(fd);
    errno = error_number;
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
}

Descriptor::~Descriptor() {
    close();
}

Descriptor Descriptor::duplicate(int fd) {
    return Descriptor(::fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

int Descriptor::close() {
    const int fd = std::exchange(fd_, -1);
    if (fd < 0 || ::close(fd) == 0 || errno == EINTR) return 0; // after EINTR Linux has closed it
    return errno;
}

bool stops(ShouldStop should_stop) {
    return should_stop != nullptr && should_stop();
}

bool wait_for(const Descriptor& descriptor, short events, ShouldStop should_stop) {
    assert(descriptor.is_open());
    constexpr int milliseconds = 50;
    while (!stops(should_stop)) {
        pollfd entry{descriptor.get(), events, 0};
        const int ready = ::poll(&entry, 1, milliseconds);
        if (ready > 0 || (ready < 0 && errno != EINTR)) return true; // an error shows in the read or write that follows
    }
    return false;
}

bool nap(ShouldStop should_stop) {
    constexpr int milliseconds = 20;
    ::poll(nullptr, 0, milliseconds);
    return !stops(should_stop);
}

std::string system_message(int error_number) {
    return std::generic_category().message(error_number);
}

} // namespace internode
