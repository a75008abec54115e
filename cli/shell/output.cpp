// SPDX-License-Identifier: MIT

#include "cli/shell/output.h"

#include "cli/requests/exit_code.h"
#include "cli/shell/signals.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <cstdlib>
#include <unistd.h>

namespace internode::cli {
namespace {

Failure file_failure(const FileError& error) {
    return failure(ExitCode::File, fmt::format("{}: {}", error.path, error.message));
}

bool wants_color(Color color) {
    if (color != Color::Auto) return color == Color::Always;
    const char* no_color = std::getenv("NO_COLOR");
    return (no_color == nullptr || *no_color == '\0') && ::isatty(STDERR_FILENO) == 1;
}

/// Nothing can be said about a stderr that fails.
void write_stderr(std::string_view text) {
    while (!text.empty()) {
        const auto count = ::write(STDERR_FILENO, text.data(), text.size());
        if (count <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

void paint(std::string& text, std::string_view word, std::string_view code) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
        const std::string painted = fmt::format("\x1b[{}m{}\x1b[0m", code, word);
        text.replace(at, word.size(), painted);
        at += painted.size();
    }
}

} // namespace

Output::Output(const std::string& path)
    : file_(path)
    , temporary_path_(file_.temporary_path()) {
    if (file_.error()) throw file_failure(*file_.error());
    remove_on_interrupt(temporary_path_);
}

Output::~Output() {
    forget(temporary_path_);
}

void Output::commit() {
    const auto error = file_.commit();
    if (error && error->kind != FileError::Kind::BrokenPipe) throw file_failure(*error);
}

void write_output(const std::string& path, std::string_view text) {
    Output output(path);
    output.sink().write(text);
    output.commit();
}

void say(const CommonOptions& common, const std::string& text) {
    std::string painted = text;
    if (wants_color(common.color)) {
        paint(painted, "error:", "1;31");
        paint(painted, "hint:", "1;36");
    }
    write_stderr(painted);
}

} // namespace internode::cli
