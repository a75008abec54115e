// SPDX-License-Identifier: MIT

#include "cli/arguments/public_command_line.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace internode::cli {
namespace {

/// The last component of a path; `-` and `@name` stay, and so does `@folder/name`.
std::string base_name(const std::string& word) {
    if (word.starts_with('@')) return word;
    const auto slash = word.find_last_of('/');
    return slash == std::string::npos || slash + 1 == word.size() ? word : word.substr(slash + 1);
}

/// Options whose value changes no byte of an output.
constexpr std::array<std::string_view, 6> silent{"-o", "--output", "--html", "--coarse", "--picture", "--threads"};

/// Options whose value is the user's text and no place.
constexpr std::array<std::string_view, 7> literal{"-e",       "--expression", "--word", "--word-u",
                                                  "--word-v", "--set",        "--query"};

bool is_silent(std::string_view option) {
    return std::ranges::find(silent, option) != silent.end();
}

bool is_literal(std::string_view option) {
    return std::ranges::find(literal, option) != literal.end();
}

} // namespace

std::string public_command_line(int argc, const char* const* argv) {
    std::string text = "internode";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (is_silent(word)) {
            ++i;
            continue;
        }
        const bool joined = is_silent(std::string_view(word).substr(0, word.find('='))) || word.starts_with("-o");
        if (joined) continue;
        const auto equals = word.find('=');
        const bool is_text = is_literal(argv[i - 1]) ||
                             (equals != std::string::npos && is_literal(std::string_view(word).substr(0, equals)));
        text += ' ';
        text += is_text ? "'" + word + "'" : base_name(word);
    }
    return text;
}

} // namespace internode::cli
