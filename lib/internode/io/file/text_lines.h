// SPDX-License-Identifier: MIT
//
// Many lines of the same kind, such as a point each: made in windows side by side, written in their order. Windows do
// not depend on the threads, nor do the bytes (docs/promises.md, P9).

#pragma once

#include "internode/io/file/sink.h"
#include "internode/stencil/parallel.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

/// Lines 0 … count - 1. `append_line(i, text)` appends line i with its end; it may throw, which ends the writing.
/// `threads` as for_each_task has them. False once the sink has failed.
template<typename AppendLine>
bool write_lines(Sink& sink, std::size_t count, int threads, const AppendLine& append_line) {
    constexpr std::size_t lines = 1024; // some 64 KiB
    const auto window = [&](std::size_t number) {
        std::string text;
        text.reserve(lines * 64);
        const std::size_t end = std::min((number + 1) * lines, count);
        for (std::size_t i = number * lines; i < end; ++i) append_line(i, text);
        return text;
    };
    return for_each_text((count + lines - 1) / lines, threads, window,
                         [&sink](std::string_view text) { return sink.write(text); });
}

} // namespace internode
