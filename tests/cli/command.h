// SPDX-License-Identifier: MIT
//
// Runs the command as a user would: its own process, its own folder with data/ in it, nothing else of the project.

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace internode::tests {

inline const std::vector<std::string> commands{"validate", "masks",    "subdivide", "converge", "reverse",
                                               "compose",  "infer",    "word",      "format",   "mesh",
                                               "formats",  "grammars", "limits"};

struct Outcome {
    int code = -1; ///< exit code, or 128 + signal
    std::string out;
    std::string err;
};

/// An empty folder with a link to data/, removed at the end; relative paths of commands start here.
class Workspace {
public:
    Workspace();
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
    ~Workspace();
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file and returns its name.
    std::string file(const std::string& name, std::string_view content) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    /// Runs `internode ARGUMENTS…` here.
    [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, std::string_view input = {}) const;
    /// Runs a line of shell in which $INTERNODE is the command; the shell is bash with pipefail.
    [[nodiscard]] Outcome shell(const std::string& line) const;

    /// Runs `internode ARGUMENTS…` here without a shell; the largest resident memory of that process in bytes.
    [[nodiscard]] std::uint64_t peak_memory(const std::vector<std::string>& arguments) const;

private:
    std::filesystem::path path_;
};

/// Expects a refusal: this exit code, these words on stderr, and nothing on stdout.
void expect_refused(const Outcome& outcome, const std::vector<std::string>& arguments, const std::string& words,
                    int code = 3);

/// The words of a line, quotes '…' taken off: enough for the examples in --help.
[[nodiscard]] std::vector<std::string> split(std::string_view line);

} // namespace internode::tests
