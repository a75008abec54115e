// SPDX-License-Identifier: MIT

#include "internode/grammar/points/cycle_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::string_view cycle_hint = "write `cycle p q^2`, `cycle p q^n` or `cycle p q^(n - 1)`";

class CycleReader {
public:
    CycleReader(const Statement& statement, const std::vector<std::string>& tables, PointContext& context)
        : tokens_(statement.tokens)
        , tables_(tables)
        , context_(context)
        , scope_(context.definitions) {}

    std::vector<CycleItem> read() {
        if (tokens_.size() == 1) refuse("cycle.empty", place_of(tokens_), "an empty cycle", cycle_hint);
        while (sound_ && index_ < tokens_.size()) read_item();
        return std::move(items_);
    }

private:
    void refuse(std::string_view code, Complaints::Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
        sound_ = false;
    }

    void read_item() {
        assert(index_ < tokens_.size());
        const Token& token = tokens_[index_++];
        const std::string_view name = text_of(token, context_.text);
        if (token.kind != TokenKind::Run) {
            if (token.kind != TokenKind::Broken)
                refuse("cycle.no-table", place_of(token), fmt::format("{} is no table", quoted(name)), cycle_hint);
            sound_ = false;
            return;
        }
        CycleItem item;
        const auto found = std::ranges::find(tables_, name);
        if (found == tables_.end()) refuse_name(token);
        sound_ = sound_ || !tables_.empty(); // a wrong name leaves the rest readable
        item.table = static_cast<std::uint32_t>(found - tables_.begin());
        if (sound_ && index_ < tokens_.size() && is_mark(tokens_[index_], context_.text, '^'))
            item.count = read_count();
        const std::size_t end = tokens_[index_ - 1].begin + tokens_[index_ - 1].bytes;
        item.place = SourcePlace{token.begin, end - token.begin};
        if (items_.size() == max_cycle_items)
            refuse("cycle.too-many-items", place_of(token),
                   fmt::format("more than {} tables in a cycle", max_cycle_items));
        else
            items_.push_back(std::move(item));
    }

    void refuse_name(const Token& token) {
        if (tables_.empty()) { // complained about as a cycle without tables
            sound_ = false;
            return;
        }
        const std::string_view name = text_of(token, context_.text);
        const std::string near = did_you_mean(name, tables_);
        refuse("cycle.no-table", place_of(token), fmt::format("no table {}", quoted(name)),
               near.empty() ? fmt::format("the first table is `{}`", tables_.front())
                            : fmt::format("did you mean `{}`?", near));
    }

    /// After `^`: a run, or parentheses.
    std::optional<Expression> read_count() {
        assert(index_ < tokens_.size());
        const Token& caret = tokens_[index_++];
        const std::size_t first = index_;
        std::size_t depth = 0;
        while (index_ < tokens_.size()) {
            if (is_mark(tokens_[index_], context_.text, '(')) ++depth;
            if (is_mark(tokens_[index_], context_.text, ')')) --depth;
            ++index_;
            if (depth == 0) break;
        }
        const std::span<const Token> count = tokens_.subspan(first, index_ - first);
        const bool is_count =
            !count.empty() && (count.front().kind == TokenKind::Run || is_mark(count.front(), context_.text, '('));
        if (!is_count) {
            refuse("word.power-without-count", place_of(caret), "`^` without a count", cycle_hint);
            return std::nullopt;
        }
        ExpressionContext expressions = context_.expressions(scope_);
        std::optional<Expression> value = read_expression(count, Wanted::Number, expressions);
        if (value && value->code.size() == 1 && !value->numbers.empty()) check_literal(value->numbers.front(), count);
        return value;
    }

    void check_literal(const Rational& count, std::span<const Token> tokens) {
        if (count.get_den() != 1 || sgn(count) < 0)
            refuse("cycle.no-count", place_of(tokens), fmt::format("{} is no count", to_string(count)),
                   "a count is 0, 1, 2, ...");
    }

    std::span<const Token> tokens_;
    const std::vector<std::string>& tables_;
    PointContext& context_;
    NameScope scope_;
    std::vector<CycleItem> items_;
    std::size_t index_ = 1;
    bool sound_ = true;
};

} // namespace

std::vector<CycleItem> read_cycle_items(const Statement& statement, const std::vector<std::string>& tables,
                                        PointContext& context) {
    return CycleReader(statement, tables, context).read();
}

} // namespace internode
