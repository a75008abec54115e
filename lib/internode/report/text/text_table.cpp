// SPDX-License-Identifier: MIT

#include "internode/report/text/text_table.h"

#include "internode/text/number.h"

#include <algorithm>
#include <array>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::size_t label_columns = 16; // of labelled lines

constexpr std::size_t line_columns = 100;
constexpr std::size_t longest_exact = 28;

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// c ρ^power for c > 0: "3/2", "2φ", "φ/2", "3φ²/2".
std::string term_text(const Rational& coefficient, std::size_t power, std::string_view generator) {
    if (power == 0) return to_string(coefficient);
    std::string text;
    if (coefficient.get_num() != 1) text += coefficient.get_num().get_str();
    text += generator;
    if (power > 1) text += superscript(static_cast<long>(power));
    if (coefficient.get_den() != 1) text += "/" + coefficient.get_den().get_str();
    return text;
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
    std::string text = "  " + std::string(label);
    text.resize(label_columns, ' ');
    return text + wrapped(sentence, label_columns) + '\n';
}

std::string rounded(double value) {
    return fmt::format("{:.4g}", value);
}

std::string rounded_up(double value) {
    std::string text = rounded(value);
    if (parse_double(text).value_or(value) >= value) return text;
    // d.ddde±XX: one unit more in the fourth digit.
    std::string digits = fmt::format("{:.3e}", value);
    const std::size_t exponent = digits.find('e');
    const std::string mantissa = digits.substr(0, 1) + digits.substr(2, exponent - 2);
    const std::string next = std::to_string(std::stoi(mantissa) + 1) + digits.substr(exponent);
    return rounded(parse_double(next).value_or(value) / 1000);
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
