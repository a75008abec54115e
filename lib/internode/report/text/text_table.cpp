// SPDX-License-Identifier: MIT
//
// Widths are counted in code points. A number is rounded up by its exact decimal digits, which every double has: the
// first four of them, one unit more where any digit is left. No rounding to a double comes between.

#include "internode/report/text/text_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::size_t label_columns = 16; // columns before the sentence of a labelled line

constexpr std::size_t line_columns = 100;
constexpr std::size_t longest_exact = 28;

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// c ρ^power for c > 0: "3/2", "2φ", "φ/2", "3φ²/2".
std::string term_text(const Rational& coefficient, std::size_t power, std::string_view generator) {
    assert(coefficient > 0);
    if (power == 0) return to_string(coefficient);
    std::string text;
    if (coefficient.get_num() != 1) text += coefficient.get_num().get_str();
    text += generator;
    if (power > 1) text += superscript(static_cast<long>(power));
    if (coefficient.get_den() != 1) text += "/" + coefficient.get_den().get_str();
    return text;
}

constexpr int shown_digits = 4; // significant ones of a rounded number

/// digits · 10^(exponent − 3), with 1000 <= digits < 10000.
struct ShortDecimal {
    int digits = 1000;
    int exponent = 0;
};

/// The least such number that is not below the value > 0: all digits of the value are looked at, none are parsed back.
ShortDecimal ceiling(double value) {
    assert(value > 0);
    constexpr int all_digits = 766; // behind the first one: no double has more
    std::array<char, all_digits + 16> exact;
    const auto [end, error] =
        std::to_chars(exact.data(), exact.data() + exact.size(), value, std::chars_format::scientific, all_digits);
    assert(error == std::errc());
    const std::string_view text(exact.data(), static_cast<std::size_t>(end - exact.data()));
    const std::size_t mark = text.find('e');
    ShortDecimal decimal{.digits = text[0] - '0'};
    for (int place = 2; place <= shown_digits; ++place)
        decimal.digits = 10 * decimal.digits + (text[static_cast<std::size_t>(place)] - '0');
    for (const char digit : text.substr(mark + 2)) decimal.exponent = 10 * decimal.exponent + (digit - '0');
    if (text[mark + 1] == '-') decimal.exponent = -decimal.exponent;
    const std::string_view rest = text.substr(shown_digits + 1, mark - shown_digits - 1);
    if (rest.find_first_not_of('0') == std::string_view::npos) return decimal;
    if (++decimal.digits == 10000) return {.digits = 1000, .exponent = decimal.exponent + 1};
    return decimal;
}

/// As "{:.4g}" writes it; the number may lie beyond the range of doubles.
std::string general_text(ShortDecimal decimal) {
    assert(1000 <= decimal.digits && decimal.digits < 10000);
    std::string digits = std::to_string(decimal.digits);
    const bool scientific = decimal.exponent < -4 || decimal.exponent >= shown_digits;
    if (!scientific && decimal.exponent < 0) digits.insert(0, static_cast<std::size_t>(-decimal.exponent), '0');
    const std::size_t whole = scientific || decimal.exponent < 0 ? 1 : static_cast<std::size_t>(decimal.exponent) + 1;
    digits.insert(whole, ".");
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return scientific ? fmt::format("{}e{:+03d}", digits, decimal.exponent) : digits;
}

} // namespace

TextTable::TextTable(std::vector<Align> columns, std::size_t indent, std::size_t gap)
    : columns_(std::move(columns))
    , indent_(indent)
    , gap_(gap) {}

TextTable& TextTable::row(std::vector<std::string> cells) {
    assert(cells.size() <= columns_.size());
    rows_.push_back(std::move(cells));
    return *this;
}

std::vector<std::size_t> TextTable::widths() const {
    std::vector<std::size_t> widths(columns_.size(), 0);
    for (const auto& cells : rows_)
        for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], columns_of(cells[c]));
    return widths;
}

bool TextTable::fits() const {
    assert(!columns_.empty());
    std::size_t columns = indent_ + gap_ * (columns_.size() - 1);
    for (const std::size_t width : widths()) columns += width;
    return columns <= line_columns;
}

std::string TextTable::text() const {
    const std::vector<std::size_t> column_widths = widths();
    std::string text;
    for (const auto& cells : rows_) {
        std::string line(indent_, ' ');
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::string padding(column_widths[c] - columns_of(cells[c]), ' ');
            line += columns_[c] == Align::Left ? cells[c] + padding : padding + cells[c];
            line.append(gap_, ' ');
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string wrapped(std::string_view sentence, std::size_t indent) {
    std::string text;
    std::size_t column = indent;
    while (!sentence.empty()) {
        const std::size_t end = std::min(sentence.find(' '), sentence.size());
        const std::string_view word = sentence.substr(0, end);
        sentence.remove_prefix(std::min(end + 1, sentence.size()));
        const bool starts_line = column == indent;
        if (!starts_line && column + 1 + columns_of(word) > line_columns) {
            text += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (!starts_line) {
            text += ' ';
            ++column;
        }
        text += word;
        column += columns_of(word);
    }
    return text;
}

std::string labelled(std::string_view label, std::string_view sentence) {
    assert(columns_of(label) + 2 < label_columns && "the sentence stands apart from its label");
    std::string text = "  " + std::string(label);
    text.resize(label_columns, ' ');
    return text + wrapped(sentence, label_columns) + '\n';
}

std::string rounded(double value) {
    return fmt::format("{:.4g}", value);
}

std::string rounded_up(double value) {
    assert(!(value < 0) && "a bound to the other side is rounded down");
    if (value == 0 || !std::isfinite(value)) return rounded(value);
    return general_text(ceiling(value));
}

std::string exact_text(const Number& number, const NumberField& field, std::string_view generator) {
    const std::vector<Rational> coefficients = number.coefficients(field);
    std::vector<std::size_t> powers;
    for (std::size_t power = coefficients.size(); power-- > 0;)
        if (coefficients[power] != 0) powers.push_back(power);
    // A term that is not negative goes first: 2−φ, not −φ+2.
    const auto lead = std::ranges::find_if(powers, [&](std::size_t power) { return coefficients[power] > 0; });
    if (lead != powers.end()) std::rotate(powers.begin(), lead, lead + 1);
    std::string text;
    for (const std::size_t power : powers) {
        if (coefficients[power] < 0)
            text += "−";
        else if (!text.empty())
            text += "+";
        text += term_text(abs(coefficients[power]), power, generator);
    }
    if (text.empty()) text = "0";
    if (columns_of(text) > longest_exact) text.clear();
    return text;
}

std::string number_text(const Number& number, const NumberField& field, std::string_view generator) {
    std::string exact = exact_text(number, field, generator);
    const std::string decimal = rounded(number.to_double());
    if (exact.empty()) return "≈ " + decimal;
    if (exact == decimal) return exact;
    return exact + " ≈ " + decimal;
}

std::string superscript(long power) {
    constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char digit : std::to_string(power))
        text += digit == '-' ? std::string_view("⁻") : digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string polynomial_text(const std::vector<Integer>& low_degree_first) {
    std::string text;
    for (std::size_t power = low_degree_first.size(); power-- > 0;) {
        const Integer& coefficient = low_degree_first[power];
        if (coefficient == 0) continue;
        if (text.empty())
            text += coefficient < 0 ? "−" : "";
        else
            text += coefficient < 0 ? " − " : " + ";
        const Integer magnitude = abs(coefficient);
        if (power == 0 || magnitude != 1) text += magnitude.get_str();
        if (power > 0) text += "x";
        if (power > 1) text += superscript(static_cast<long>(power));
    }
    return text.empty() ? "0" : text;
}

} // namespace internode
