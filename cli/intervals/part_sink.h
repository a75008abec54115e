// SPDX-License-Identifier: MIT
//
// One table of several in a CSV file: the names stand once, above all of them, and what parts a table from the one
// before stands under the names.

#pragma once

#include "internode/io/file/sink.h"

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

} // namespace internode::cli
