// SPDX-License-Identifier: MIT
//
// Plain text for a terminal: aligned columns, wrapped sentences, numbers as a reader wants them.
//
// Widths count code points. Text of a user has been made printable (text/diagnostic.h) by whoever puts it here.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/interval/quantity.h"

#include <string>
#include <string_view>
#include <vector>

namespace internode {

enum class Align { Left, Right };

class TextTable {
public:
    /// One alignment a column; the columns are set apart by `gap` blanks, each line starts with `indent` blanks.
    explicit TextTable(std::vector<Align> columns, std::size_t indent = 2, std::size_t gap = 2);
    /// At most as many cells as columns; the rest is empty.
    TextTable& row(std::vector<std::string> cells);
    /// All lines, each with its newline and without blanks at its end.
    [[nodiscard]] std::string text() const;
    /// Whether the longest line has at most 100 columns.
    [[nodiscard]] bool fits() const;

private:
    [[nodiscard]] std::vector<std::size_t> widths() const;

    std::vector<Align> columns_;
    std::size_t indent_;
    std::size_t gap_;
    std::vector<std::vector<std::string>> rows_;
};

/// Lines of at most 100 columns, broken at blanks; all but the first start with `indent` blanks, and the first is
/// taken to stand after as many columns.
[[nodiscard]] std::string wrapped(std::string_view sentence, std::size_t indent);

/// "  label         sentence" on its own lines: the sentence in column 16 and after, wrapped.
[[nodiscard]] std::string labelled(std::string_view label, std::string_view sentence);

/// Four significant digits: "0.2361", "1.235e-07".
[[nodiscard]] std::string rounded(double value);

/// The same for an upper bound >= 0: the least number of four digits that is not below the value, exactly. Above the
/// largest double it may be one that no double holds: "1.798e+308".
[[nodiscard]] std::string rounded_up(double value);

/// "2φ−3", "2−φ", "1−φ/2" in the given name of the field's generator; or empty when it takes more than 28 columns.
[[nodiscard]] std::string exact_text(const Number& number, const NumberField& field, std::string_view generator);

/// "2φ−3 ≈ 0.2361", "1/2", "≈ 1.234": the exact text first where it is known and short.
[[nodiscard]] std::string number_text(const Number& number, const NumberField& field, std::string_view generator);

/// "⁻¹²".
[[nodiscard]] std::string superscript(long power);

/// "x² − x − 1".
[[nodiscard]] std::string polynomial_text(const std::vector<Integer>& low_degree_first);

} // namespace internode
