// SPDX-License-Identifier: MIT

#include "cli/arguments/option_checks.h"

#include "cli/requests/exit_code.h"
#include "internode/curve/knots.h"
#include "internode/text/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace internode::cli {
namespace {

/// What a variable of the environment asks for: one of two names, or nothing.
template<typename Value>
Value environment_choice(const char* variable, Value usual,
                         const std::array<std::pair<std::string_view, Value>, 2>& choices) {
    const char* const wanted = std::getenv(variable);
    if (wanted == nullptr || *wanted == '\0') return usual;
    for (const auto& [name, value] : choices)
        if (wanted == name) return value;
    throw failure(ExitCode::Usage,
                  fmt::format("{} is neither `{}` nor `{}`", variable, choices[0].first, choices[1].first),
                  "it changes the speed, no result");
}

} // namespace

std::string positive_number(const std::string& text) {
    const std::optional<double> value = parse_double(text);
    return value && *value > 0 ? std::string() : fmt::format("`{}` is not a positive number", text);
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return value;
}

std::optional<std::int64_t> integer(const std::string& text) {
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return value;
}

std::vector<int> degrees(std::string_view text) {
    std::vector<int> result;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto degree = whole_number(std::string(text.substr(begin, end - begin)));
        if (!degree || *degree < 1 || *degree > max_degree || result.size() == 2) return {};
        result.push_back(static_cast<int>(*degree));
        begin = end + 1;
    }
    return result;
}

std::string whole_number_problem(const std::string& text) {
    return whole_number(text) ? std::string() : fmt::format("`{}` is not a whole number from 0 to 2^64 - 1", text);
}

std::string integer_problem(const std::string& text) {
    return integer(text) ? std::string() : fmt::format("`{}` is not an integer within 64 bits", text);
}

std::string empty_word_problem(const std::string& text) {
    return text.empty() ? "an empty word has no intervals" : std::string();
}

Isa isa_of_environment() {
    return environment_choice<Isa>("INTERNODE_ISA", Isa::Best, {{{"plain", Isa::Plain}, {"avx2", Isa::Avx2}}});
}

Stores stores_of_environment() {
    return environment_choice<Stores>("INTERNODE_STORES", Stores::Measured,
                                      {{{"cached", Stores::Cached}, {"streamed", Stores::Streamed}}});
}

} // namespace internode::cli
