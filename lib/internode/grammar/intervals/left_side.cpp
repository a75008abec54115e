// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/left_side.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/opening.h"
#include "internode/grammar/lexing/word_reader.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

class LeftSideReader {
public:
    LeftSideReader(std::string_view text, Complaints& complaints)
        : text_(text)
        , complaints_(complaints) {}

    void read(const Statement& statement) {
        assert(statement.arrow && *statement.arrow < statement.tokens.size());
        const std::span<const Token> left = statement.tokens.first(*statement.arrow);
        const bool is_symbol = left.size() == 1 && left.front().kind == TokenKind::Run &&
                               symbol_length(text_of(left.front(), text_)) == left.front().bytes;
        sides_.symbols.push_back(is_symbol ? define(left.front()) : std::nullopt);
        if (!is_symbol) refuse(statement, left);
    }
    void skip() { sides_.symbols.emplace_back(); }

    [[nodiscard]] bool is_full() const { return !sides_.readable; }
    LeftSides sides() && { return std::move(sides_); }

private:
    std::optional<Symbol> define(const Token& token) {
        const std::string_view name = text_of(token, text_);
        if (name.size() > max_name_bytes) {
            complaints_.add("word.symbol-too-long", place_of(token), too_long_symbol(name));
            sides_.excused.emplace(name);
            return std::nullopt;
        }
        if (const auto known = sides_.alphabet.find(name)) {
            const std::size_t line = complaints_.line_of(places_[to_index(*known)]);
            complaints_.add("grammar.second-rule", place_of(token), fmt::format("a second rule for {}", quoted(name)),
                            fmt::format("the first is in line {}", line));
            return std::nullopt;
        }
        if (sides_.alphabet.size() == max_symbols) {
            complaints_.add("grammar.too-many-symbols", place_of(token),
                            fmt::format("more than {} symbols", max_symbols));
            sides_.readable = false;
            return std::nullopt;
        }
        assert(places_.size() == sides_.alphabet.size());
        places_.push_back(token.begin);
        return sides_.alphabet.add(name);
    }

    void excuse(std::string_view run) {
        while (!run.empty()) {
            const std::size_t length = symbol_length(run);
            if (length > 0) sides_.excused.emplace(run.substr(0, length));
            run.remove_prefix(std::max<std::size_t>(length, 1));
        }
    }

    void refuse(const Statement& statement, std::span<const Token> left) {
        const auto is_broken = [](const Token& token) { return token.kind == TokenKind::Broken; };
        for (const Token& token : left)
            if (token.kind == TokenKind::Run) excuse(text_of(token, text_));
        if (std::ranges::any_of(left, is_broken)) return;
        const std::string hint = "a rule of an interval grammar has one symbol before `->`";
        if (left.empty()) {
            complaints_.add("rule.empty-left-side", place_of(statement.tokens[*statement.arrow]),
                            "no symbol before `->`", hint);
            return;
        }
        const Complaints::Place place = place_of(left);
        const std::string_view fragment = text_.substr(place.offset, place.bytes);
        if (fragment.find_first_not_of('0') == std::string_view::npos)
            complaints_.add("rule.of-zero", place, "`0` has no rule of its own: it stays `0`", "leave this rule out");
        else if (is_kind(text_of(left.front(), text_)))
            complaints_.add("rule.not-one-symbol", place, fmt::format("{} is not one symbol", quoted(fragment)),
                            "the kind of the grammar stands on a line of its own");
        else
            complaints_.add("rule.not-one-symbol", place, fmt::format("{} is not one symbol", quoted(fragment)), hint);
    }

    std::string_view text_;
    Complaints& complaints_;
    LeftSides sides_;
    std::vector<std::size_t> places_; ///< offset of each symbol's rule
};

} // namespace

LeftSides read_left_sides(const Statements& split, std::size_t first, std::string_view text, Complaints& complaints) {
    LeftSideReader reader(text, complaints);
    for (std::size_t i = 0; i < split.statements.size() && !reader.is_full(); ++i) {
        if (i >= first && split.statements[i].arrow)
            reader.read(split.statements[i]);
        else
            reader.skip();
    }
    return std::move(reader).sides();
}

} // namespace internode
