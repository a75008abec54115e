// SPDX-License-Identifier: MIT

#include "cli/shell/output.h"

#include "cli/shell/exit_code.h"
#include "cli/shell/signals.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <unistd.h>

namespace internode::cli {
namespace {

Failure file_failure(const FileError& error) {
    return failure(ExitCode::File, fmt::format("{}: {}", error.path, error.message));
}

/// "svg" of "out/coast.svg"; empty without an extension.
std::string extension(const std::string& path) {
    const auto slash = path.find_last_of('/');
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    const auto dot = name.find_last_of('.');
    if (dot == std::string::npos || dot == 0) return {};
    std::string text = name.substr(dot + 1);
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

/// The format that an extension stands for, mostly itself.
std::string format_of(const std::string& written) {
    if (written == "txt") return "text";
    if (written == "h") return "c";
    if (written == "comp") return "glsl";
    return written;
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

std::string chosen_format(const OutputTarget& target, const std::vector<std::string>& formats,
                          const std::string& fallback) {
    const std::string written = extension(target.file);
    std::string name = format_of(written);
    const bool known = std::ranges::find(formats, name) != formats.end();
    if (!target.format.empty() && known && name != target.format)
        throw failure(ExitCode::Usage,
                      fmt::format("the format {} and the extension `.{}` of -o disagree", target.format, written));
    if (!target.format.empty() && std::ranges::find(formats, target.format) == formats.end())
        throw failure(ExitCode::Usage, fmt::format("no format {} for this output", target.format),
                      fmt::format("use one of {}", fmt::join(formats, ", ")));
    if (!target.format.empty()) return target.format;
    if (target.file == "-" || target.file.rfind("/dev/", 0) == 0 || name.empty()) return fallback;
    if (known) return name;
    std::vector<std::string> extensions = formats;
    std::ranges::replace(extensions, std::string("text"), std::string("txt"));
    std::ranges::replace(extensions, std::string("c"), std::string("h"));
    throw failure(ExitCode::Usage, fmt::format("no format for the extension `.{}`", written),
                  fmt::format("use one of .{}, or --format", fmt::join(extensions, ", .")));
}

Output::Output(const std::string& path)
    : file_(path) {
    if (file_.error()) throw file_failure(*file_.error());
    remove_on_interrupt(file_.temporary_path());
}

Output::~Output() {
    remove_on_interrupt({});
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
