// SPDX-License-Identifier: MIT

#include "internode/grammar/expressions/expression_symbols.h"

#include <algorithm>
#include <array>

namespace internode {

namespace {

struct Symbols {
    Operation operation;
    std::string_view printed;
    int precedence;
};

constexpr std::array<Symbols, 19> symbols{{{Operation::Or, "or", 1},
                                           {Operation::And, "and", 2},
                                           {Operation::Not, "not", 3},
                                           {Operation::Less, "<", 4},
                                           {Operation::LessEqual, "<=", 4},
                                           {Operation::Greater, ">", 4},
                                           {Operation::GreaterEqual, ">=", 4},
                                           {Operation::Equal, "==", 4},
                                           {Operation::NotEqual, "!=", 4},
                                           {Operation::Add, "+", 5},
                                           {Operation::Subtract, "-", 5},
                                           {Operation::Multiply, "*", 6},
                                           {Operation::Divide, "/", 6},
                                           {Operation::Negate, "-", 7},
                                           {Operation::Minimum, "min", 8},
                                           {Operation::Maximum, "max", 8},
                                           {Operation::Floor, "floor", 8},
                                           {Operation::Absolute, "abs", 8},
                                           {Operation::SquareRoot, "sqrt", 8}}};

const Symbols* find_symbols(Operation operation) {
    const auto* found = std::ranges::find(symbols, operation, &Symbols::operation);
    return found == symbols.end() ? nullptr : found;
}

struct Sign {
    std::string_view text;
    Operation operation;
};

/// The longest first.
constexpr std::array<Sign, 16> signs{{{"<=", Operation::LessEqual},
                                      {">=", Operation::GreaterEqual},
                                      {"==", Operation::Equal},
                                      {"!=", Operation::NotEqual},
                                      {"\xE2\x89\xA4", Operation::LessEqual},
                                      {"\xE2\x89\xA5", Operation::GreaterEqual},
                                      {"\xE2\x89\xA0", Operation::NotEqual},
                                      {"\xC2\xB7", Operation::Multiply},
                                      {"\xE2\x8B\x85", Operation::Multiply},
                                      {"<", Operation::Less},
                                      {">", Operation::Greater},
                                      {"=", Operation::Equal},
                                      {"+", Operation::Add},
                                      {"-", Operation::Subtract},
                                      {"*", Operation::Multiply},
                                      {"/", Operation::Divide}}};

struct Remedy {
    std::string_view sign;
    std::string_view hint;
};

constexpr std::array<Remedy, 7> remedies{{{"^", "write `x x`, or `x * x`"},
                                          {"&", "write `and`"},
                                          {"|", "write `or`, or `abs(x)`"},
                                          {"!", "write `not`, or `!=`"},
                                          {"%", "write `x - 2 floor(x/2)`"},
                                          {"[", "a point is written `(x, y)`"},
                                          {":", "a rule is `label : P(v) : condition -> successor : weight`"}}};

} // namespace

int precedence(Operation operation) {
    const Symbols* found = find_symbols(operation);
    return found == nullptr ? primary_precedence : found->precedence;
}

std::optional<Operation> builtin_function(std::string_view name) {
    const auto* found = std::ranges::find(symbols, name, &Symbols::printed);
    if (found == symbols.end() || found->precedence != primary_precedence) return std::nullopt;
    return found->operation;
}

std::string_view sign_of(Operation operation) {
    const Symbols* found = find_symbols(operation);
    return found == nullptr ? std::string_view() : found->printed;
}

std::optional<BinarySign> find_binary_sign(const TokenCursor& cursor) {
    const TokenKind kind = cursor.token().kind;
    if (kind != TokenKind::Mark && kind != TokenKind::Comparison && kind != TokenKind::Foreign) return std::nullopt;
    const std::string_view here = cursor.text().substr(cursor.offset(), 3);
    for (const Sign& sign : signs)
        if (here.starts_with(sign.text)) return BinarySign{sign.operation, sign.text.size()};
    return std::nullopt;
}

std::string_view hint_for_sign(std::string_view sign) {
    const auto* found = std::ranges::find(remedies, sign, &Remedy::sign);
    return found == remedies.end() ? std::string_view() : found->hint;
}

} // namespace internode
