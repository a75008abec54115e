// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/word_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/text/ascii.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>

#include <fmt/format.h>

namespace internode {

namespace {

class WordReader {
public:
    WordReader(std::span<const Token> tokens, const WordContext& context, Complaints& complaints)
        : tokens_(tokens)
        , context_(context)
        , complaints_(complaints) {}

    ReadWord read() {
        while (!stopped_ && index_ < tokens_.size()) read_item();
        if (!stopped_) finish();
        return std::move(result_);
    }

private:
    [[nodiscard]] const Token& token() const {
        assert(index_ < tokens_.size());
        return tokens_[index_];
    }
    [[nodiscard]] bool at_mark(char mark) const {
        return index_ < tokens_.size() && inside_ == 0 && is_mark(token(), context_.text, mark);
    }
    [[nodiscard]] std::size_t place() const { return token().begin + inside_; }

    void refuse(std::string_view code, Complaints::Place where, std::string message, std::string hint = {}) {
        complaints_.add(code, where, std::move(message), std::move(hint));
        result_.damaged = true;
    }
    void stop(std::string_view code, Complaints::Place where, std::string message, std::string hint = {}) {
        refuse(code, where, std::move(message), std::move(hint));
        stopped_ = true;
    }
    void next_token() {
        ++index_;
        inside_ = 0;
    }
    void advance(std::size_t bytes) {
        inside_ += bytes;
        if (inside_ >= token().bytes) next_token();
    }

    void read_item() {
        if (token().kind == TokenKind::Run)
            read_letter();
        else if (at_mark('('))
            open();
        else if (at_mark(')'))
            close();
        else
            refuse_token();
    }

    void read_letter() {
        const std::string_view run = text_of(token(), context_.text).substr(inside_);
        const std::size_t before = result_.word.size();
        if (const std::size_t length = symbol_length(run); length > 0) {
            read_symbol(run.substr(0, length));
        } else if (run.front() == '0') {
            read_zero();
        } else {
            refuse_run(run);
            return;
        }
        if (!stopped_) read_power(before);
    }

    void read_symbol(std::string_view name) {
        const std::size_t offset = place();
        if (name.size() > max_name_bytes) {
            stop("word.symbol-too-long", {offset, name.size()}, too_long_symbol(name));
            return;
        }
        if (const auto symbol = context_.symbols.find(name))
            push(*symbol, {offset, name.size()});
        else if (seen_.insert(name).second)
            result_.unknown.push_back({name, offset});
        advance(name.size());
    }

    void read_zero() {
        if (context_.place == WordPlace::Rule) {
            if (!zero_refused_)
                refuse("word.zero-in-rule", {place(), 1}, "`0` may stand in words only, never in a rule",
                       "an interval of length zero comes from the axiom and stays as it is");
            zero_refused_ = true;
        } else {
            push(zero_interval, {place(), 1});
        }
        advance(1);
    }

    [[nodiscard]] std::size_t allowed() const {
        assert(context_.used <= max_word_letters);
        return std::min(context_.max_letters, max_word_letters - context_.used);
    }

    [[nodiscard]] std::string too_many_letters() const {
        return allowed() == context_.max_letters
                   ? fmt::format("a word of more than {} letters", context_.max_letters)
                   : fmt::format("words of more than {} letters in all", max_word_letters);
    }

    void push(Symbol symbol, Complaints::Place where) {
        if (result_.word.size() >= allowed())
            stop("word.too-long", where, too_many_letters());
        else
            result_.word.push_back(symbol);
    }

    void refuse_run(std::string_view run) {
        if (is_ascii_digit(run.front())) {
            const auto other = std::ranges::find_if_not(run, is_ascii_digit);
            const std::string_view digits = run.substr(0, static_cast<std::size_t>(other - run.begin()));
            stop("word.number", {place(), digits.size()}, fmt::format("{} is no letter of a word", quoted(digits)),
                 fmt::format("to repeat a letter write `L^{}`; `0` is the interval of length zero",
                             digits.substr(0, 20)));
            return;
        }
        stop("word.no-symbol", {place(), 1}, fmt::format("{} follows no symbol", quoted(run.substr(0, 1))),
             "a symbol is a letter, then digits, `_` or `'`");
    }

    void open() {
        if (group_) {
            stop("word.nested-parentheses", {place(), 1}, "parentheses inside parentheses",
                 "write the word with one level; `ring` makes an axiom circular without parentheses");
            return;
        }
        group_ = Group{index_, result_.word.size()};
        next_token();
    }

    void close() {
        if (!group_) {
            stop("grammar.unbalanced", {place(), 1}, "`)` was never opened");
            return;
        }
        const std::size_t opening = tokens_[group_->token].begin;
        if (group_->token + 1 == index_) {
            stop("word.empty-parentheses", {opening, place() + 1 - opening}, "empty parentheses");
            return;
        }
        const Group group = *group_;
        group_.reset();
        next_token();
        if (at_mark('^')) {
            read_power(group.letters);
        } else if (context_.place == WordPlace::Axiom && group.token == 0 && index_ == tokens_.size()) {
            result_.ends = Ends::Circular;
        } else {
            stop("word.parentheses-without-power", {opening, 1}, "parentheses without a power",
                 context_.place == WordPlace::Axiom
                     ? "`(L S)^2` repeats; parentheses round the whole word make it circular"
                     : "write `(L S)^2`, or leave the parentheses out");
        }
    }

    /// Repeats the letters from `start` on when a power follows.
    void read_power(std::size_t start) {
        if (!at_mark('^')) return;
        const Complaints::Place caret{place(), 1};
        next_token();
        if (index_ >= tokens_.size() || token().kind != TokenKind::Run ||
            !is_ascii_digit(context_.text[token().begin])) {
            stop("word.power-without-count", caret, "`^` without a count", "write `L^3` or `(L S)^3`");
            return;
        }
        const std::string_view run = text_of(token(), context_.text);
        const auto other = std::ranges::find_if_not(run, is_ascii_digit);
        const std::string_view digits = run.substr(0, static_cast<std::size_t>(other - run.begin()));
        repeat(start, digits);
        if (stopped_) return;
        advance(digits.size());
        if (at_mark('^')) stop("word.power-of-power", {place(), 1}, "a power of a power", "write one power");
    }

    void repeat(std::size_t start, std::string_view digits) {
        const Complaints::Place where{place(), digits.size()};
        const std::uint64_t count = value_of(digits);
        const std::size_t letters = result_.word.size() - start;
        if (count == 0) {
            stop("word.power-of-zero", where, "a power must be at least 1");
            return;
        }
        assert(start <= allowed());
        // An unknown symbol has no letters here, but would have had some: the count alone is bounded as well.
        const std::uint64_t room = allowed() - start;
        if (count > room / std::max<std::size_t>(letters, 1)) {
            stop("word.power-too-large", where, "this power makes " + too_many_letters());
            return;
        }
        result_.word.resize(start + letters * count);
        for (std::size_t i = start + letters; i < result_.word.size(); ++i) result_.word[i] = result_.word[i - letters];
    }

    /// The number, or something larger than any limit.
    static std::uint64_t value_of(std::string_view digits) {
        std::uint64_t value = 0;
        for (const char digit : digits) {
            value = 10 * value + static_cast<std::uint64_t>(digit - '0');
            if (value > max_word_letters) break;
        }
        return value;
    }

    void refuse_token() {
        const std::string_view fragment = text_of(token(), context_.text);
        const Complaints::Place where{place(), token().bytes};
        switch (token().kind) {
        case TokenKind::Broken:
            result_.damaged = true; // complained about where the tokens are made
            stopped_ = true;
            return;
        case TokenKind::Unbalanced:
            stop("grammar.unbalanced", where, fragment == "(" ? "`(` is never closed" : "`)` was never opened");
            return;
        case TokenKind::Epsilon:
            stop("rule.empty-successor", where, "an interval cannot become nothing",
                 "a rule has at least one symbol after `->`");
            return;
        case TokenKind::Arrow:
            stop("rule.second-arrow", where, "a second `->` in one statement",
                 "begin each rule on a line of its own, or after `,`");
            return;
        default:
            stop("word.foreign-sign", where, fmt::format("{} has no meaning in a word", quoted(fragment)),
                 hint_for(fragment));
        }
    }

    [[nodiscard]] static std::string hint_for(std::string_view fragment) {
        if (fragment == "^") return "write `L^3` or `(L S)^3`";
        if (fragment == ",") return "letters stand side by side or between blanks";
        if (fragment == ".") return "a rule has at least one symbol after `->`";
        return {};
    }

    void finish() {
        if (group_) {
            refuse("grammar.unbalanced", {tokens_[group_->token].begin, 1}, "`(` is never closed");
            return;
        }
        if (!result_.word.empty() || !result_.unknown.empty() || result_.damaged) return;
        refuse("word.empty", {tokens_.front().begin, 1}, "a word without letters");
    }

    struct Group {
        std::size_t token = 0;   ///< index of `(`
        std::size_t letters = 0; ///< letters of the word before the parenthesis
    };

    std::span<const Token> tokens_;
    const WordContext& context_;
    Complaints& complaints_;
    ReadWord result_;
    std::size_t index_ = 0;  ///< the token at hand
    std::size_t inside_ = 0; ///< bytes of the token read already
    std::optional<Group> group_;
    std::unordered_set<std::string_view> seen_; ///< names that are no symbols
    bool stopped_ = false;
    bool zero_refused_ = false;
};

} // namespace

SymbolTable::SymbolTable(const Alphabet& alphabet)
    : alphabet_(&alphabet) {
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        const std::string& name = alphabet.names()[i];
        assert(!name.empty());
        const auto first = static_cast<unsigned char>(name.front());
        if (name.size() == 1 && first < single_.size()) single_[first] = to_symbol(i);
    }
}

std::optional<Symbol> SymbolTable::find(std::string_view name) const {
    assert(!name.empty());
    const auto first = static_cast<unsigned char>(name.front());
    if (name.size() == 1 && first < single_.size()) return single_[first];
    return alphabet_->find(name);
}

std::size_t symbol_length(std::string_view run) {
    if (run.empty() || !is_ascii_letter(run.front())) return 0;
    const auto tail = run.substr(1);
    const auto other =
        std::ranges::find_if_not(tail, [](char c) { return is_ascii_digit(c) || c == '_' || c == '\''; });
    return 1 + static_cast<std::size_t>(other - tail.begin());
}

std::string too_long_symbol(std::string_view name) {
    return fmt::format("a symbol of {} characters, more than {}", name.size(), max_name_bytes);
}

ReadWord read_word(std::span<const Token> tokens, const WordContext& context, Complaints& complaints) {
    assert(!tokens.empty());
    return WordReader(tokens, context, complaints).read();
}

} // namespace internode
