// SPDX-License-Identifier: MIT

#include "internode/io/file/input_file.h"

#include "internode/io/file/descriptor.h"
#include "internode/text/place.h"

#include <cassert>
#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace internode {

namespace {

using Kind = FileError::Kind;

constexpr std::size_t chunk_bytes = std::size_t{1} << 18;

FileError open_error(const std::string& source, int error_number) {
    switch (error_number) {
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG:
        return {.kind = Kind::Missing, .path = source, .message = "no such file"};
    case EBADF:
        return {.kind = Kind::Unreadable, .path = source, .message = "closed"};
    default:
        return {.kind = Kind::Unreadable, .path = source, .message = system_message(error_number)};
    }
}

FileError too_large(const std::string& source, std::uint64_t limit) {
    return {.kind = Kind::TooLarge, .path = source, .message = "more than " + std::to_string(limit) + " bytes"};
}

/// Reads an open file to its end into `text`.
class Reader {
public:
    Reader(InputText& result, const InputOptions& options)
        : result_(result)
        , options_(options) {}

    std::optional<FileError> read(const Descriptor& file) {
        struct stat status {};
        if (::fstat(file.get(), &status) != 0) return open_error(result_.source, errno);
        if (S_ISDIR(status.st_mode)) return error(Kind::Directory, "is a folder");
        if (S_ISREG(status.st_mode)) {
            const auto size = static_cast<std::uint64_t>(status.st_size);
            if (size > options_.max_bytes) return too_large(result_.source, options_.max_bytes);
            result_.text.reserve(size);
        }
        return read_chunks(file);
    }

private:
    FileError error(Kind kind, std::string message) const {
        return {.kind = kind, .path = result_.source, .message = std::move(message)};
    }

    std::optional<FileError> read_chunks(const Descriptor& file) {
        std::vector<char> chunk(chunk_bytes);
        while (true) {
            if (!wait_for(file, POLLIN, options_.should_stop)) return error(Kind::Interrupted, "interrupted");
            const ssize_t count = ::read(file.get(), chunk.data(), chunk.size());
            if (count == 0) return std::nullopt;
            if (count > 0) {
                if (auto refusal = take({chunk.data(), static_cast<std::size_t>(count)})) return refusal;
            } else if (errno == EISDIR) {
                return error(Kind::Directory, "is a folder");
            } else if (errno != EINTR && errno != EAGAIN) {
                return error(Kind::Unreadable, system_message(errno));
            }
        }
    }

    std::optional<FileError> take(std::string_view bytes) {
        assert(result_.text.size() <= options_.max_bytes);
        const std::size_t zero = options_.may_be_binary ? std::string_view::npos : bytes.find('\0');
        if (zero != std::string_view::npos) return not_text(bytes.substr(0, zero));
        if (bytes.size() > options_.max_bytes - result_.text.size())
            return too_large(result_.source, options_.max_bytes);
        result_.text.append(bytes);
        return std::nullopt;
    }

    FileError not_text(std::string_view before) {
        result_.text.append(before);
        const TextPlace place = place_of(result_.text, result_.text.size());
        FileError refusal = error(Kind::NotText, "a byte 0: this is not a text");
        refusal.line = place.line;
        refusal.column = place.column;
        return refusal;
    }

    InputText& result_;
    const InputOptions& options_;
};

/// Without O_NONBLOCK the opening of a FIFO would wait for its writer, deaf to should_stop.
Descriptor open_input(std::string_view path) {
    if (path == "-") return Descriptor::duplicate(STDIN_FILENO);
    if (path.find('\0') != std::string_view::npos) {
        errno = ENOENT;
        return {};
    }
    return Descriptor(::open(std::string(path).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
}

} // namespace

InputText read_input(std::string_view path, const InputOptions& options) {
    InputText result;
    result.source = path == "-" ? "<stdin>" : path;
    const Descriptor file = open_input(path);
    result.error = file.is_open() ? Reader(result, options).read(file) : open_error(result.source, errno);
    if (result.error) result.text = {};
    return result;
}

} // namespace internode
