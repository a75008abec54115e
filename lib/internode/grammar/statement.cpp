// SPDX-License-Identifier: MIT

#include "internode/grammar/statement.h"

#include <algorithm>
#include <utility>

namespace internode {

namespace {

bool continues(const Token& token, std::string_view text) {
    if (token.kind == TokenKind::Arrow || token.kind == TokenKind::Comparison) return true;
    return token.kind == TokenKind::Mark &&
           std::string_view(":<>+-*/").find(text[token.begin]) != std::string_view::npos;
}

/// Where a statement begins and ends in the kept tokens.
struct Extent {
    std::size_t first = 0;
    std::size_t last = 0;
    std::optional<std::size_t> arrow;
};

class Splitter {
public:
    explicit Splitter(std::string_view text)
        : text_(text) {}

    void read(const Token& token) {
        const bool at_end = depth_ == 0 && !(kept_.size() > current_.first && continues(kept_.back(), text_));
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
        if (is_mark(token, text_, '(')) ++depth_;
        if (is_mark(token, text_, ')')) --depth_;
        if (token.kind == TokenKind::Arrow) {
            // `L ->` at the end of a line took the next rule for its successor: give it back.
            if (current_.arrow && line_start_ > current_.first + *current_.arrow) finish(line_start_);
            if (!current_.arrow) current_.arrow = kept_.size() - current_.first;
        }
        kept_.push_back(token);
    }

    /// The statement has the kept tokens up to `last`; the next begins there.
    void finish(std::size_t last) {
        current_.last = last;
        if (last > current_.first) extents_.push_back(current_);
        current_ = {last, last, std::nullopt};
    }

    std::string_view text_;
    std::vector<Token> kept_;
    std::vector<Extent> extents_;
    Extent current_;
    std::size_t line_start_ = 0; ///< index of the first kept token of this line
    std::size_t depth_ = 0;
};

} // namespace

void mark_unbalanced(std::vector<Token>& tokens, std::string_view text) {
    std::vector<std::size_t> open;
    const auto give_up = [&] {
        for (const std::size_t i : open) tokens[i].kind = TokenKind::Unbalanced;
        open.clear();
    };
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind == TokenKind::Arrow || is_mark(tokens[i], text, '=')) {
            give_up();
        } else if (is_mark(tokens[i], text, '(')) {
            open.push_back(i);
        } else if (is_mark(tokens[i], text, ')')) {
            if (open.empty())
                tokens[i].kind = TokenKind::Unbalanced;
            else
                open.pop_back();
        }
    }
    give_up();
}

Statements split_statements(std::vector<Token> tokens, std::string_view text) {
    mark_unbalanced(tokens, text);
    Splitter splitter(text);
    for (const Token& token : tokens) splitter.read(token);
    return std::move(splitter).statements();
}

} // namespace internode
