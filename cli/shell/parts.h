// SPDX-License-Identifier: MIT
//
// The parts of a file on their way out again: one table of several in a CSV file, where the names stand once, above all
// of them, and what parts a table from the one before stands under the names; and outputs that hold one part alone.

#pragma once

#include "internode/io/file/sink.h"

#include <cstddef>
#include <string>

namespace internode::cli {

class PartSink final : public Sink {
public:
    /// `break_text` goes where the first line ends; that line is kept of the first part alone. The sink must outlive
    /// it.
    PartSink(Sink& sink, bool is_first, std::string break_text)
        : sink_(sink)
        , is_first_(is_first)
        , break_text_(std::move(break_text)) {}

    bool write(std::string_view bytes) override;

private:
    Sink& sink_;
    bool is_first_;
    std::string break_text_;
    bool in_first_line_ = true;
};

/// What parts a table from the one before, as its own file says it; a blank line where that says nothing (JSON, OBJ).
[[nodiscard]] std::string written_break(const std::string& break_text, bool is_first);

/// \throw Failure (Refused) where there are several parts and the output, "npy" or "a tree", holds one
void refuse_several(std::size_t count, const std::string& output);

/// \throw Failure (Refused) for the columns of a part that are not as many as those of the first, in CSV
void require_equal_columns(std::size_t first, std::size_t other);

/// \throw Failure (Refused) where some parts have one coordinate and others have more: no picture shows both
void require_one_plane(std::size_t first_dimension, std::size_t other_dimension);

} // namespace internode::cli
