// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/length_reader.h"

#include "internode/grammar/lexing/limits.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::string_view length_hint = "write `length L = 3/2`";

/// The number's characters; blanks are left out beside `/` only, and elsewhere spoil it.
std::string number_text(std::span<const Token> tokens, std::string_view text) {
    std::string number;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool apart = i > 0 && tokens[i - 1].begin + tokens[i - 1].bytes < tokens[i].begin;
        const bool beside_slash = i > 0 && (is_mark(tokens[i], text, '/') || is_mark(tokens[i - 1], text, '/'));
        if (apart && !beside_slash) number += ' ';
        number += text_of(tokens[i], text);
    }
    return number;
}

} // namespace

std::optional<SymbolUse> LengthReader::read(const Statement& statement) {
    const std::span<const Token> tokens = statement.tokens;
    if (std::ranges::any_of(tokens, [](const Token& token) { return token.kind == TokenKind::Broken; })) return {};
    const Token& subject = tokens[tokens.size() > 1 ? 1 : 0];
    const std::string_view name = text_of(subject, text_);
    const bool is_symbol = tokens.size() > 1 && subject.kind == TokenKind::Run && symbol_length(name) == name.size();
    if (!is_symbol || name.size() > max_name_bytes) {
        complaints_.add("length.no-symbol", place_of(subject), "`length` needs one symbol", std::string(length_hint));
        return {};
    }
    const std::optional<Symbol> symbol = symbols_.find(name);
    if (tokens.size() < 3 || !is_mark(tokens[2], text_, '=')) {
        complaints_.add("length.no-equals", place_of(tokens[std::min<std::size_t>(2, tokens.size() - 1)]),
                        fmt::format("no `=` after `length {}`", name), std::string(length_hint));
    } else if (tokens.size() < 4) {
        complaints_.add("length.no-number", place_of(tokens[2]), "no number after `=`", std::string(length_hint));
    } else if (const auto length = read_number(tokens.subspan(3)); length && symbol) {
        declare(*symbol, *length, subject);
    }
    return symbol ? std::nullopt : std::optional(SymbolUse{name, subject.begin});
}

std::optional<Rational> LengthReader::read_number(std::span<const Token> tokens) {
    const std::string number = number_text(tokens, text_);
    std::optional<Rational> length = parse_rational(number);
    // `9e400` may have more digits written out than may be read again.
    if (!length || !parse_rational(to_string(*length))) {
        complaints_.add(
            "length.not-a-number", place_of(tokens), fmt::format("{} is not a number", internode::quoted(number)),
            fmt::format("write `3/2` or `1.5`; at most {} digits, exponent at most {}", max_digits, max_exponent));
        return std::nullopt;
    }
    if (*length <= 0) {
        complaints_.add("length.not-positive", place_of(tokens),
                        fmt::format("a length must be positive, not {}", internode::quoted(number)),
                        "`0` in a word is the interval of length zero");
        return std::nullopt;
    }
    return length;
}

void LengthReader::declare(Symbol symbol, const Rational& length, const Token& token) {
    assert(length > 0);
    const auto [place, is_new] = index_.try_emplace(to_index(symbol), declared_.size());
    if (is_new) {
        declared_.push_back({symbol, length});
        return;
    }
    const Rational& first = declared_[place->second].length;
    if (first == length) return;
    complaints_.add("length.contradiction", place_of(token),
                    fmt::format("the length of {} is {} here and {} before", quoted(text_of(token, text_)),
                                to_string(length), to_string(first)),
                    "two declarations must agree exactly");
}

} // namespace internode
