// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/token_cursor.h"

#include "internode/text/ascii.h"

#include <algorithm>

namespace internode {

namespace {

std::size_t count_digits(std::string_view run) {
    const auto other = std::ranges::find_if_not(run, is_ascii_digit);
    return static_cast<std::size_t>(other - run.begin());
}

/// The digits that follow a point which is token `ahead`, joined to it.
std::size_t count_decimals(const TokenCursor& cursor, std::size_t ahead) {
    const bool follows = cursor.at_mark('.', ahead) && cursor.is_joined(ahead) && cursor.is_run(ahead + 1);
    return follows ? count_digits(cursor.text_ahead(ahead + 1)) : 0;
}

} // namespace

std::size_t end_of_number(const TokenCursor& cursor, std::size_t ahead) {
    const std::string_view first = ahead == 0 ? cursor.rest() : cursor.text_ahead(ahead);
    const std::size_t begin = static_cast<std::size_t>(first.data() - cursor.text().data());
    if (const std::size_t decimals = count_decimals(cursor, ahead); decimals > 0) return begin + 1 + decimals;
    const std::size_t digits = cursor.is_run(ahead) ? count_digits(first) : 0;
    if (digits == 0 || digits < first.size() || !cursor.is_joined(ahead)) return begin + digits;
    const std::size_t decimals = count_decimals(cursor, ahead + 1);
    return begin + digits + (decimals > 0 ? 1 + decimals : 0);
}

} // namespace internode
