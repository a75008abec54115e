// SPDX-License-Identifier: MIT
//
// An output file appears whole or not at all.
//
// A regular target is written beside itself, as `.NAME.internode-XXXXXXXX.tmp` in the same folder, and renamed over the
// target by commit() after fsync; the folder is synced too. The mode (and, where allowed, the owner) of an existing
// target is kept, symbolic links are followed. `-`, /dev/stdout, /dev/fd/N, devices and FIFOs are written directly and
// never renamed over. A process killed in between leaves the target as it was, at worst with the temporary file beside
// it. SIGPIPE and SIGXFSZ belong to the caller: ignored, their cases arrive here as errors.

#pragma once

#include "internode/io/file/file_error.h"
#include "internode/io/file/sink.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace internode {

class OutputFile final : public Sink {
public:
    /// Opens `path` (`-`: standard output), so that an unwritable target is known before anything is computed: look at
    /// error() first. Waits for the reader of a FIFO. Buffers about 64 KiB.
    explicit OutputFile(std::string_view path, ShouldStop should_stop = nullptr);
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&& other) noexcept;
    /// Without commit() the target stays as it was and the temporary file goes.
    ~OutputFile() override;

    bool write(std::string_view bytes) override;

    /// Everything to the disk and the file to its name. Returns the first error of the whole life of this file; then
    /// the target is as it was (unless only the sync of its folder failed). \throw std::logic_error when called twice
    [[nodiscard]] std::optional<FileError> commit();

    /// The first error so far.
    [[nodiscard]] const std::optional<FileError>& error() const;

    /// The temporary file being written; empty when the target is written directly, and after commit().
    [[nodiscard]] const std::string& temporary_path() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace internode
