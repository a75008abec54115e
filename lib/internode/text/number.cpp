// SPDX-License-Identifier: MIT

#include "internode/text/number.h"

#include "internode/text/ascii.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <system_error>

namespace internode {

namespace {

/// The exponent after `e` or `E`, cut at ±10^9: beyond that only its sign matters, as no text is that long.
std::int64_t clamped_exponent(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    std::int64_t value = 0;
    assert(std::ranges::all_of(text, is_ascii_digit));
    for (const char c : text) value = std::min<std::int64_t>(10 * value + (c - '0'), 1'000'000'000);
    return negative ? -value : value;
}

/// Whether an unsigned decimal number that is no double is too small for one, rather than too large.
/// Its first digit that is not 0 tells: from_chars gives the same error for both.
bool underflows(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    assert(first != std::string_view::npos);
    const std::int64_t exponent = e == std::string_view::npos ? 0 : clamped_exponent(text.substr(e + 1));
    return static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) + exponent < 0;
}

} // namespace

std::optional<double> parse_double(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || !(is_ascii_digit(text.front()) || text.front() == '.')) return std::nullopt;
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        if (!underflows(text)) return std::nullopt;
        value = 0;
    }
    return negative ? -value : value;
}

void append(std::string& text, double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number that is not finite has no decimal text");
    std::array<char, 32> buffer; // the longest shortest double has 24 characters: -2.2250738585072014e-308
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    assert(error == std::errc());
    text.append(buffer.data(), end);
}

std::string to_string(double value) {
    std::string text;
    append(text, value);
    return text;
}

} // namespace internode
