// SPDX-License-Identifier: MIT
//
// Results on their way out: to stdout or to a file that appears whole or not at all.

#pragma once

#include "cli/requests/options.h"
#include "internode/io/file/output_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode::cli {

/// An open output; the target is known to be writable before any work begins.
class Output {
public:
    /// \throw Failure (File)
    explicit Output(const std::string& path);
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    ~Output();
    [[nodiscard]] Sink& sink() { return file_; }
    /// \throw Failure (File); returns quietly when the reader of a pipe has gone
    void commit();

private:
    OutputFile file_;
    std::string temporary_path_;
};

/// The whole of a small result. \throw Failure (File)
void write_output(const std::string& path, std::string_view text);

/// Something for stderr, as it stands: errors, warnings, notes. Colours `error:` and `hint:` when asked to.
void say(const CommonOptions& common, const std::string& text);

} // namespace internode::cli
