// SPDX-License-Identifier: MIT

#include "internode/grammar/points/module_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/token_cursor.h"
#include "internode/grammar/lexing/word_reader.h"
#include "internode/text/ascii.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

const std::vector<std::string>& statement_words() {
    static const std::vector<std::string> words{"axiom", "cycle", "input", "interpretation", "points", "ring", "table"};
    return words;
}

/// A rule whose successor was forgotten goes on with the next line: its first word, well spelt or not.
std::string near_statement_word(std::string_view run) {
    constexpr std::size_t shortest = 4;
    constexpr std::size_t longest = 16;
    return run.size() < shortest || run.size() > longest ? std::string() : did_you_mean(run, statement_words());
}

class ModuleReader {
public:
    ModuleReader(std::span<const Token> tokens, ModulePlace where, std::string_view text, Complaints& complaints)
        : tokens_(tokens)
        , text_(text)
        , where_(where)
        , complaints_(complaints)
        , cursor_(tokens, text) {}

    RawModules read() {
        while (!result_.damaged && !cursor_.at_end()) {
            check_count();
            if (!result_.damaged) read_item();
        }
        if (!result_.damaged && depth_ > 0) refuse("module.branch-unbalanced", {open_, 1}, "`[` is never closed here");
        return std::move(result_);
    }

private:
    using Place = Complaints::Place;

    void refuse(std::string_view code, Place place, std::string message, std::string_view hint = {}) {
        complaints_.add(code, place, std::move(message), std::string(hint));
        result_.damaged = true;
    }

    void check_count() {
        const bool is_pattern = where_ == ModulePlace::Pattern;
        const std::size_t limit = is_pattern ? max_predecessor_modules : max_point_modules;
        if (result_.modules.size() == limit)
            refuse("module.too-many", cursor_.place(),
                   fmt::format("more than {} modules {}", limit, is_pattern ? "before the arrow" : "in one grammar"));
    }

    void read_item() {
        if (cursor_.is_run()) {
            read_letter(cursor_.offset());
        } else if (cursor_.at_mark('?')) {
            read_query();
        } else if (cursor_.at_mark('#')) {
            keep_mark();
            if (cursor_.at_mark('(')) refuse("module.marker-with-parameters", cursor_.place(), "`#` has no parameters");
        } else if (cursor_.at_mark('[') || cursor_.at_mark(']')) {
            read_bracket();
        } else {
            refuse_token();
        }
    }

    void keep_mark() {
        result_.modules.push_back({cursor_.rest(), cursor_.place(), {}, 1});
        cursor_.next();
    }

    void read_bracket() {
        if (where_ == ModulePlace::Pattern) {
            refuse("module.bracket-before-arrow", cursor_.place(), "a bracket before the arrow",
                   "contexts step over branches by themselves; brackets are never rewritten");
            return;
        }
        const bool opens = cursor_.at_mark('[');
        if (!opens && depth_ == 0) {
            refuse("module.branch-unbalanced", cursor_.place(), "`]` was never opened here");
            return;
        }
        if (opens && depth_ == 0) open_ = cursor_.offset();
        depth_ = opens ? depth_ + 1 : depth_ - 1;
        keep_mark();
        if (cursor_.at_mark('^'))
            refuse("module.power-of-bracket", cursor_.place(), "a power of a bracket",
                   "a power repeats one module: `X^3`");
    }

    void read_query() {
        const std::size_t begin = cursor_.offset();
        const bool is_joined = cursor_.is_joined() && cursor_.is_run(1) && symbol_length(cursor_.text_ahead(1)) > 0;
        if (!is_joined) {
            refuse("module.query-without-letter", cursor_.place(), "`?` without a letter",
                   "a query module is written `?Q(x)`");
            return;
        }
        cursor_.next();
        read_letter(begin);
    }

    /// `begin`: of the letter, which a `?` may precede.
    void read_letter(std::size_t begin) {
        const std::string_view run = cursor_.rest();
        const std::size_t length = symbol_length(run);
        if (length == 0) {
            refuse("module.no-module", cursor_.place(), fmt::format("{} is no module", quoted(run)),
                   "a letter, then digits, `_` or `'`, then parameters: `P(v)`");
            return;
        }
        if (const std::string word = near_statement_word(run); !word.empty()) {
            refuse("module.statement-word", cursor_.place(),
                   fmt::format("{} begins a statement", internode::quoted(word)),
                   "a successor that the line before lacks is written `.`; letters may stand apart");
            return;
        }
        const std::size_t end = cursor_.offset() + length;
        if (length > max_name_bytes) {
            refuse("word.symbol-too-long", {begin, end - begin}, too_long_symbol(run.substr(0, length)));
            return;
        }
        RawModule module{text_.substr(begin, end - begin), {begin, end - begin}, {}, 1};
        cursor_.advance(length);
        if (cursor_.at_mark('(')) read_parameters(module);
        if (!result_.damaged && cursor_.at_mark('^')) read_power(module);
        result_.modules.push_back(std::move(module));
    }

    /// The index of the closing parenthesis: it exists, because others are TokenKind::Unbalanced.
    [[nodiscard]] std::size_t find_close(std::size_t open) const {
        std::size_t depth = 0;
        std::size_t i = open;
        for (; i + 1 < tokens_.size(); ++i) {
            if (is_mark(tokens_[i], text_, '(')) ++depth;
            if (is_mark(tokens_[i], text_, ')') && --depth == 0) break;
        }
        return i;
    }

    void read_parameters(RawModule& module) {
        assert(cursor_.at_mark('('));
        const std::size_t open = cursor_.index();
        const std::size_t close = find_close(open);
        std::size_t first = open + 1;
        std::size_t depth = 0;
        for (std::size_t i = first; i <= close; ++i) {
            const bool ends = depth == 0 && (i == close || is_mark(tokens_[i], text_, ','));
            if (ends && i == first) {
                const bool is_empty = i == close && first == open + 1;
                refuse("module.no-parameter", place_of(tokens_.subspan(i - 1, 2)), "no parameter here",
                       is_empty ? "a module without parameters has no parentheses: `E`" : "");
                return;
            }
            if (ends) {
                module.parameters.push_back(tokens_.subspan(first, i - first));
                first = i + 1;
            }
            if (is_mark(tokens_[i], text_, '(')) ++depth;
            if (is_mark(tokens_[i], text_, ')')) --depth;
        }
        module.place.bytes = tokens_[close].begin + 1 - module.place.offset;
        if (module.parameters.size() > max_parameters)
            refuse("module.too-many-parameters", module.place,
                   fmt::format("a module of {} parameters, more than {}", module.parameters.size(), max_parameters));
        cursor_.move_to(tokens_[close].begin + 1);
    }

    void read_power(RawModule& module) {
        const Place caret = cursor_.place();
        cursor_.next();
        const std::string_view run = cursor_.is_run() ? cursor_.rest() : std::string_view();
        const auto other = std::ranges::find_if_not(run, is_ascii_digit);
        const auto digits = static_cast<std::size_t>(other - run.begin());
        if (where_ == ModulePlace::Pattern) {
            refuse("module.power-before-arrow", caret, "a power before the arrow", "write the modules side by side");
        } else if (digits == 0) {
            refuse("word.power-without-count", caret, "`^` without a count", "write `X^3`");
        } else {
            module.power = count_of(run.substr(0, digits));
            if (module.power == 0)
                refuse("word.power-of-zero", {cursor_.offset(), digits}, "a power must be at least 1");
            module.power = std::max<std::size_t>(module.power, 1);
            cursor_.advance(digits);
            if (!result_.damaged && cursor_.at_mark('^'))
                refuse("word.power-of-power", cursor_.place(), "a power of a power", "write one power");
        }
    }

    /// The number, or something larger than any limit.
    static std::size_t count_of(std::string_view digits) {
        std::size_t count = 0;
        for (const char digit : digits)
            count = std::min(10 * count + static_cast<std::size_t>(digit - '0'), 10 * max_point_modules);
        return count;
    }

    void refuse_token() {
        const std::string_view fragment = cursor_.rest();
        const TokenKind kind = cursor_.token().kind;
        if (kind == TokenKind::Broken) {
            result_.damaged = true; // complained about where the tokens are made
        } else if (kind == TokenKind::Unbalanced) {
            const bool opens = fragment == "(" || fragment == "[";
            refuse("grammar.unbalanced", cursor_.place(),
                   fmt::format("`{}` {}", fragment, opens ? "is never closed" : "was never opened"));
        } else if (kind == TokenKind::Epsilon || fragment == ".") {
            refuse("module.empty-among-modules", cursor_.place(), fmt::format("{} among modules", quoted(fragment)),
                   "it is the empty successor and stands alone");
        } else if (kind == TokenKind::Arrow) {
            refuse("rule.second-arrow", cursor_.place(), "a second `->` in one statement",
                   "begin each rule on a line of its own, or after `,`");
        } else if (fragment == "(") {
            refuse("module.parentheses-without-letter", cursor_.place(), "parentheses without a letter",
                   "parameters follow a letter: `P(v)`");
        } else {
            refuse("module.no-module", cursor_.place(), fmt::format("{} is no module", quoted(fragment)),
                   fragment == "^" ? "a power follows a module: `X^3`" : "");
        }
    }

    std::span<const Token> tokens_;
    std::string_view text_;
    ModulePlace where_;
    Complaints& complaints_;
    TokenCursor cursor_;
    RawModules result_;
    std::size_t depth_ = 0;
    std::size_t open_ = 0; ///< where the outermost bracket opens
};

} // namespace

bool is_statement_word(std::string_view run) {
    return std::ranges::find(statement_words(), run) != statement_words().end();
}

RawModules read_modules(std::span<const Token> tokens, ModulePlace where, std::string_view text,
                        Complaints& complaints) {
    return ModuleReader(tokens, where, text, complaints).read();
}

} // namespace internode
