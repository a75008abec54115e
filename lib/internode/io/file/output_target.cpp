// SPDX-License-Identifier: MIT
//
// Symbolic links are followed here, one by one, instead of by the kernel. The folder of the target itself must be
// known, to write beside it, and a link may end at the name of an open descriptor.

#include "internode/io/file/output_target.h"

#include "internode/text/ascii.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <climits>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace internode {

namespace {

using Kind = FileError::Kind;

constexpr int max_links = 40; // as the kernel

/// N of /dev/fd/N and its other names: such a path means an open descriptor, whatever stands behind it.
std::optional<int> descriptor_of(std::string_view path) {
    if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(prefix)) continue;
        const std::string_view digits = path.substr(prefix.size());
        const bool plain = std::ranges::all_of(digits, is_ascii_digit);
        if (plain && !digits.empty() && digits.size() <= 6) return std::stoi(std::string(digits));
    }
    return std::nullopt;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

/// Where a symbolic link points, seen from the folder it stands in; empty with errno set when that cannot be read.
std::string read_link(const std::string& path) {
    assert(!path.empty());
    std::array<char, PATH_MAX> buffer;
    const ssize_t size = ::readlink(path.c_str(), buffer.data(), buffer.size());
    if (size <= 0) return {};
    std::string link(buffer.data(), static_cast<std::size_t>(size));
    return link.starts_with('/') ? link : folder_of(path) + '/' + link;
}

class Resolver {
public:
    Resolver(std::string_view path, ShouldStop should_stop)
        : path_(path)
        , should_stop_(should_stop) {}

    OutputTarget resolve() && {
        for (int links = 0; links <= max_links; ++links) {
            if (const auto fd = descriptor_of(path_)) return take(Descriptor::duplicate(*fd), "closed");
            struct stat status {};
            if (::lstat(path_.c_str(), &status) != 0) {
                if (errno != ENOENT) return refuse(errno);
                return in_folder();
            }
            if (!S_ISLNK(status.st_mode)) return existing(status);
            path_ = read_link(path_);
            if (path_.empty()) return refuse(errno);
        }
        return refuse(ELOOP);
    }

private:
    OutputTarget refuse(Kind kind, std::string message) {
        target_.error = FileError{.kind = kind, .message = std::move(message)};
        return std::move(target_);
    }

    OutputTarget refuse(int error_number) { return refuse(Kind::Unwritable, system_message(error_number)); }

    OutputTarget existing(const struct stat& status) {
        if (S_ISDIR(status.st_mode)) return refuse(Kind::Directory, "is a folder");
        if (!S_ISREG(status.st_mode)) return open_directly();
        if (::faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) return refuse(errno);
        target_.mode = status.st_mode & 07777U;
        target_.owner = status.st_uid;
        target_.group = status.st_gid;
        return in_folder();
    }

    OutputTarget in_folder() {
        target_.folder = folder_of(path_);
        target_.name = path_.substr(path_.rfind('/') + 1);
        if (path_.empty()) return refuse(Kind::Unwritable, "an empty name");
        if (target_.name.empty()) return refuse(Kind::Missing, "no such folder");
        return std::move(target_);
    }

    /// A FIFO without a reader answers ENXIO: asked again until one comes.
    OutputTarget open_directly() {
        while (true) {
            const int fd = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
            struct stat status {};
            if (fd >= 0) return take(Descriptor(fd), "cannot be written");
            if (errno != ENXIO && errno != EINTR) return refuse(errno);
            if (errno == ENXIO && (::stat(path_.c_str(), &status) != 0 || !S_ISFIFO(status.st_mode)))
                return refuse(ENXIO);
            if (!nap(should_stop_)) return refuse(Kind::Interrupted, "interrupted");
        }
    }

    OutputTarget take(Descriptor descriptor, const char* otherwise) {
        struct stat status {};
        if (!descriptor.is_open() || ::fstat(descriptor.get(), &status) != 0)
            return refuse(Kind::Unwritable, otherwise);
        if ((::fcntl(descriptor.get(), F_GETFL) & O_ACCMODE) == O_RDONLY)
            return refuse(Kind::Unwritable, "open for reading only");
        target_.is_stream = !S_ISREG(status.st_mode);
        target_.direct = std::move(descriptor);
        return std::move(target_);
    }

    std::string path_;
    ShouldStop should_stop_;
    OutputTarget target_;
};

} // namespace

OutputTarget resolve_output(std::string_view path, ShouldStop should_stop) {
    return Resolver(path.substr(0, path.find('\0')), should_stop).resolve();
}

} // namespace internode
