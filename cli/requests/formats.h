// SPDX-License-Identifier: MIT
//
// The formats that the command writes, as one table, and which command writes which. The default of a command, the
// check of --format and of the extension of -o, the list in --help and `internode formats` all read it. The handler of
// a kind has a writer for each format of its row.

#pragma once

#include "cli/requests/belonging.h"
#include "cli/requests/options.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode::cli {

/// A format by its name on the command line.
struct Format {
    std::string_view name;                      ///< "mtx"
    std::array<std::string_view, 2> extensions; ///< extensions of files, without the point; the second may be empty
    std::string_view called;                    ///< the format in a sentence: "MatrixMarket"
    std::string_view what;                      ///< what a file of the format holds, in one line
};

/// The file that a row of the table is about.
enum class Destination : std::uint8_t {
    Output, ///< -o, or stdout
    OwnFile ///< the file that the option itself names: --picture FILE
};

/// The formats of one output of a command, for one kind of grammar; the first is the default.
struct FormatUse {
    std::string_view command;
    std::optional<Kind> kind; ///< none: the command reads no grammar
    std::string_view option;  ///< the option that asks for this output; empty for the usual one
    std::vector<std::string> formats;
    Destination destination = Destination::Output;
};

[[nodiscard]] std::span<const Format> formats();
[[nodiscard]] std::span<const FormatUse> format_uses();

/// The format of that name; null when there is none.
[[nodiscard]] const Format* find_format(std::string_view name);

/// The formats that --format of a command takes, of all kinds, each once.
[[nodiscard]] std::vector<std::string> formats_of(std::string_view command);

/// Which output of a command is meant: a row of the table.
struct OutputOf {
    std::string_view command;
    std::optional<Kind> kind; ///< the kind, as FormatUse::kind
    std::string_view option;  ///< the option, as FormatUse::option
};

/// The format that --format, or else the extension of -o, asks for; when neither says it `usual`, a format of the row,
/// or the first of the row. \throw Failure (Usage) for a format that is not in the row
[[nodiscard]] std::string chosen_format(const OutputTarget& target, const OutputOf& output,
                                        std::string_view usual = {});

/// chosen_format() where every option on the command line has been found to do something with this kind and format.
/// \throw Failure (Usage) for a format that is not in the row, and for options that would do nothing
[[nodiscard]] std::string settled_format(const Context& context, const OutputTarget& target, const OutputOf& output,
                                         std::string_view usual = {});

/// A format with what writes it.
template<class Writer>
struct FormatWriter {
    std::string_view format;
    Writer writer;
};

/// The writer of a format that the table of a handler has.
template<class Writer>
[[nodiscard]] Writer writer_of(const std::vector<FormatWriter<Writer>>& table, std::string_view format) {
    for (const FormatWriter<Writer>& row : table)
        if (row.format == format) return row.writer;
    assert(false && "the handler of a kind writes each format of its row");
    return table.front().writer;
}

} // namespace internode::cli
