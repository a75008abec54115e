// SPDX-License-Identifier: MIT

#include "internode/io/file/output_file.h"

#include "internode/io/file/output_target.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace internode {

namespace {

using Kind = FileError::Kind;

constexpr std::size_t buffer_bytes = std::size_t{1} << 16;
/// POSIX's smallest PIPE_BUF is 512, Linux has a page: so much fits without waiting once poll() says POLLOUT.
constexpr std::size_t stream_chunk_bytes = 4096;
/// Of the 255 bytes of a file name, what stays for NAME beside ".", ".internode-XXXXXXXX" and ".tmp".
constexpr std::size_t max_kept_name = 200;

std::string temporary_name(const std::string& name) {
    std::uint32_t number = 0;
    if (::getrandom(&number, sizeof number, GRND_NONBLOCK) < 0) number = static_cast<std::uint32_t>(::getpid());
    std::string digits(8, '0');
    for (char& digit : digits) {
        digit = "0123456789abcdef"[number % 16];
        number /= 16;
    }
    return '.' + name.substr(0, max_kept_name) + ".internode-" + digits + ".tmp";
}

/// Some file systems cannot sync and say so; that is no failure to write.
bool sync(const Descriptor& descriptor) {
    return ::fsync(descriptor.get()) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

} // namespace

struct OutputFile::Impl {
    std::string shown_path;
    ShouldStop should_stop = nullptr;
    OutputTarget target;
    Descriptor folder;          ///< open while the temporary file exists
    Descriptor file;            ///< what is written
    std::string temporary;      ///< its name in the folder
    std::string temporary_path; ///< its name for the world
    std::string buffer;
    std::optional<FileError> error;
    bool committed = false;

    ~Impl() { remove_temporary(); }

    void fail(Kind kind, std::string message) {
        if (!error) error = FileError{.kind = kind, .path = shown_path, .message = std::move(message)};
    }

    void open(std::string_view path) {
        shown_path = path == "-" ? "<stdout>" : path;
        target = resolve_output(path, should_stop);
        if (target.error) return fail(target.error->kind, target.error->message);
        if (target.direct.is_open())
            file = std::move(target.direct);
        else
            open_beside();
    }

    /// The folder is held by a descriptor: it may be renamed, or left by chdir, while we compute.
    void open_beside() {
        assert(!target.name.empty() && !target.folder.empty());
        folder = Descriptor(::open(target.folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        if (!folder.is_open()) return fail(Kind::Missing, "no such folder");
        constexpr int tries = 100; // 2^-32 for each stray file of an earlier kill
        for (int i = 0; i < tries && !file.is_open(); ++i) {
            temporary = temporary_name(target.name);
            constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW;
            file = Descriptor(::openat(folder.get(), temporary.c_str(), flags, 0666));
            if (!file.is_open() && errno != EEXIST) break;
        }
        if (!file.is_open()) {
            temporary.clear();
            return fail(Kind::Unwritable, system_message(errno));
        }
        temporary_path = target.folder + '/' + temporary;
        if (target.mode) keep_mode();
    }

    /// The owner as far as we may, first: a change of owner clears the set-user bit.
    void keep_mode() {
        assert(target.mode && file.is_open());
        const bool owner_kept = ::fchown(file.get(), target.owner, target.group) == 0;
        const mode_t mode = owner_kept ? *target.mode : (*target.mode & 0777U);
        if (::fchmod(file.get(), mode) != 0) fail(Kind::Unwritable, system_message(errno));
    }

    void flush() {
        std::string_view rest = buffer;
        while (!error && !rest.empty()) {
            const ssize_t count = write_some(rest);
            if (count > 0)
                rest.remove_prefix(static_cast<std::size_t>(count));
            else if (!error && (count == 0 || (errno != EINTR && errno != EAGAIN)))
                fail(errno == EPIPE ? Kind::BrokenPipe : Kind::WriteFailed,
                     count == 0 ? "nothing could be written" : system_message(errno));
        }
        buffer.clear();
    }

    ssize_t write_some(std::string_view bytes) {
        assert(!bytes.empty() && file.is_open());
        const bool go_on = target.is_stream ? wait_for(file, POLLOUT, should_stop) : !stops(should_stop);
        if (!go_on) {
            fail(Kind::Interrupted, "interrupted");
            return -1;
        }
        return ::write(file.get(), bytes.data(),
                       target.is_stream ? std::min(bytes.size(), stream_chunk_bytes) : bytes.size());
    }

    void finish() {
        flush();
        const bool beside = !temporary.empty();
        if (!error && stops(should_stop)) fail(Kind::Interrupted, "interrupted");
        if (!error && beside && !sync(file)) fail(Kind::WriteFailed, system_message(errno));
        if (const int closing = file.close(); !error && closing != 0) fail(Kind::WriteFailed, system_message(closing));
        if (!error && beside) rename();
        remove_temporary();
    }

    void rename() {
        assert(folder.is_open() && !temporary.empty());
        if (::renameat(folder.get(), temporary.c_str(), folder.get(), target.name.c_str()) != 0)
            return fail(Kind::WriteFailed, system_message(errno));
        temporary.clear();
        const Descriptor readable(::openat(folder.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (readable.is_open() && !sync(readable)) fail(Kind::WriteFailed, system_message(errno));
    }

    void remove_temporary() {
        if (!temporary.empty()) ::unlinkat(folder.get(), temporary.c_str(), 0);
        temporary.clear();
        temporary_path.clear();
    }
};

OutputFile::OutputFile(std::string_view path, ShouldStop should_stop)
    : impl_(std::make_unique<Impl>()) {
    impl_->should_stop = should_stop;
    impl_->open(path);
}

OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

bool OutputFile::write(std::string_view bytes) {
    if (impl_->error) return false;
    impl_->buffer.append(bytes);
    if (impl_->buffer.size() >= buffer_bytes) impl_->flush();
    return !impl_->error;
}

std::optional<FileError> OutputFile::commit() {
    if (impl_->committed) throw std::logic_error("OutputFile::commit: called twice");
    impl_->committed = true;
    impl_->finish();
    return impl_->error;
}

const std::optional<FileError>& OutputFile::error() const {
    return impl_->error;
}

const std::string& OutputFile::temporary_path() const {
    return impl_->temporary_path;
}

} // namespace internode
