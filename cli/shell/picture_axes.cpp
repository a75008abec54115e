// SPDX-License-Identifier: MIT

#include "cli/shell/picture_axes.h"

#include "cli/requests/exit_code.h"

#include <fmt/format.h>

#include <charconv>

namespace internode::cli {

PictureAxes chosen_axes(const std::string& text, std::size_t dimension) {
    PictureAxes axes;
    axes.up = dimension > 1 ? 1 : 0;
    if (text.empty()) return axes;
    std::size_t pair[2] = {0, 0};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair[0]);
    const bool comma = first.ec == std::errc() && first.ptr != end && *first.ptr == ',';
    const auto second = comma ? std::from_chars(first.ptr + 1, end, pair[1]) : first;
    const bool whole = comma && second.ec == std::errc() && second.ptr == end;
    if (!whole || pair[0] < 1 || pair[1] < 1 || pair[0] > dimension || pair[1] > dimension || pair[0] == pair[1])
        throw failure(ExitCode::Usage,
                      fmt::format("--axes wants two different coordinates between 1 and {}, like 1,2", dimension));
    return {pair[0] - 1, pair[1] - 1};
}

} // namespace internode::cli
