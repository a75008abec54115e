// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/statement.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace internode {

namespace {

bool is_one_of(const Token& token, std::string_view text, std::string_view marks) {
    return token.kind == TokenKind::Mark && marks.find(text[token.begin]) != std::string_view::npos;
}

std::string_view openers(Brackets brackets) {
    return brackets == Brackets::Round ? "(" : "([";
}
std::string_view closers(Brackets brackets) {
    return brackets == Brackets::Round ? ")" : ")]";
}

bool continues(const Token& token, std::string_view text, Brackets brackets) {
    if (token.kind == TokenKind::Arrow || token.kind == TokenKind::Comparison) return true;
    return is_one_of(token, text, brackets == Brackets::Round ? ":<>+-*/" : ":<>+-*/|");
}

/// Where a statement begins and ends in the kept tokens.
struct Extent {
    std::size_t first = 0;
    std::size_t last = 0;
    std::optional<std::size_t> arrow;
};

class Splitter {
public:
    Splitter(std::string_view text, Brackets brackets)
        : text_(text)
        , brackets_(brackets) {}

    void read(const Token& token) {
        const bool at_end =
            depth_ == 0 && !(kept_.size() > current_.first && continues(kept_.back(), text_, brackets_));
        if (token.kind == TokenKind::Newline) {
            line_start_ = kept_.size();
            if (at_end) finish(kept_.size());
            return;
        }
        if (depth_ == 0 && (is_mark(token, text_, ',') || is_mark(token, text_, ';'))) {
            finish(kept_.size());
            return;
        }
        keep(token);
    }

    Statements statements() && {
        finish(kept_.size());
        Statements result{std::move(kept_), {}};
        const std::span<const Token> all(result.tokens);
        for (const Extent& extent : extents_)
            result.statements.push_back({all.subspan(extent.first, extent.last - extent.first), extent.arrow});
        return result;
    }

private:
    void keep(const Token& token) {
        if (is_one_of(token, text_, openers(brackets_))) ++depth_;
        if (is_one_of(token, text_, closers(brackets_))) --depth_;
        if (token.kind == TokenKind::Arrow) {
            // `L ->` at the end of a line took the next rule for its successor: give it back.
            if (current_.arrow && line_start_ > current_.first + *current_.arrow) finish(line_start_);
            if (!current_.arrow) current_.arrow = kept_.size() - current_.first;
        }
        kept_.push_back(token);
    }

    /// The statement has the kept tokens up to `last`; the next begins there.
    void finish(std::size_t last) {
        assert(last >= current_.first && last <= kept_.size());
        current_.last = last;
        if (last > current_.first) extents_.push_back(current_);
        current_ = {last, last, std::nullopt};
    }

    std::string_view text_;
    Brackets brackets_;
    std::vector<Token> kept_;
    std::vector<Extent> extents_;
    Extent current_;
    std::size_t line_start_ = 0; ///< index of the first kept token of this line
    std::size_t depth_ = 0;
};

/// The brackets that wait for their partners.
class OpenBrackets {
public:
    OpenBrackets(std::vector<Token>& tokens, std::string_view text)
        : tokens_(tokens)
        , text_(text) {}

    void push(std::size_t i) {
        open_.push_back(i);
        ++(is_round(i) ? round_ : square_);
    }
    /// A closing bracket takes the last opening one of its shape; what was opened after that has no partner.
    void close(std::size_t i) {
        const bool round = text_[tokens_[i].begin] == ')';
        if ((round ? round_ : square_) == 0) {
            tokens_[i].kind = TokenKind::Unbalanced;
            return;
        }
        assert(round_ + square_ == open_.size());
        while (is_round(open_.back()) != round) drop_last();
        pop();
    }
    void give_up() {
        while (!open_.empty()) drop_last();
    }

private:
    [[nodiscard]] bool is_round(std::size_t i) const { return text_[tokens_[i].begin] == '('; }
    void pop() {
        assert(!open_.empty());
        --(is_round(open_.back()) ? round_ : square_);
        open_.pop_back();
    }
    void drop_last() {
        tokens_[open_.back()].kind = TokenKind::Unbalanced;
        pop();
    }

    std::vector<Token>& tokens_;
    std::string_view text_;
    std::vector<std::size_t> open_;
    std::size_t round_ = 0;
    std::size_t square_ = 0;
};

} // namespace

void mark_unbalanced(std::vector<Token>& tokens, std::string_view text, Brackets brackets) {
    OpenBrackets open(tokens, text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind == TokenKind::Arrow || (brackets == Brackets::Round && is_mark(tokens[i], text, '=')))
            open.give_up();
        else if (is_one_of(tokens[i], text, openers(brackets)))
            open.push(i);
        else if (is_one_of(tokens[i], text, closers(brackets)))
            open.close(i);
    }
    open.give_up();
}

Statements split_statements(std::vector<Token> tokens, std::string_view text, Brackets brackets) {
    mark_unbalanced(tokens, text, brackets);
    Splitter splitter(text, brackets);
    for (const Token& token : tokens) splitter.read(token);
    return std::move(splitter).statements();
}

} // namespace internode
