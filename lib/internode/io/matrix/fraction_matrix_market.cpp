// SPDX-License-Identifier: MIT
//
// Banner, sizes, entries: an error in one ends the reading before the next. Entries are kept as they come, those of a
// symmetric matrix twice; at the end rows are sorted, a place that was given twice is refused, and zeros go.

#include "internode/io/file/limits.h"
#include "internode/io/matrix/fraction_entry.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "internode/text/ascii.h"
#include "internode/text/lines.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>

namespace internode {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

/// A whole number of at most 18 digits.
std::optional<std::uint64_t> count(std::string_view text) {
    constexpr std::size_t most_digits = 18;
    const bool digits = std::ranges::all_of(text, is_ascii_digit);
    if (text.empty() || text.size() > most_digits || !digits) return std::nullopt;
    std::uint64_t value = 0;
    for (const char c : text) value = 10 * value + static_cast<std::uint64_t>(c - '0');
    return value;
}

class MatrixMarketReader {
public:
    MatrixMarketReader(std::string_view text, std::string_view source)
        : lines_(text, source, "matrix.unexpected") {}

    ParsedFractionMatrix read() && {
        if (read_banner() && read_sizes()) read_entries();
        if (lines_.errors().empty()) order_rows();
        if (!lines_.errors().empty()) return {.matrix = {}, .errors = std::move(lines_.errors())};
        return {.matrix = std::move(matrix_), .errors = {}};
    }

private:
    /// The next line that is no comment and not empty, in pieces_; false at the end.
    bool next() {
        while (lines_.next()) {
            pieces_ = blank_separated(lines_.line());
            if (!pieces_.empty() && pieces_.front().text.front() != '%') return true;
        }
        return false;
    }

    bool read_banner() {
        do {
            if (!lines_.next()) {
                lines_.refuse_text("no MatrixMarket banner");
                return false;
            }
            pieces_ = blank_separated(lines_.line());
        } while (pieces_.empty());
        const bool whole = pieces_.size() == 5 && lower(pieces_[0].text) == "%%matrixmarket";
        if (!whole || lower(pieces_[1].text) != "matrix") {
            lines_.refuse(pieces_.front(), "no MatrixMarket banner",
                          "the first line is: %%MatrixMarket matrix coordinate real general");
            return false;
        }
        return one_of(pieces_[2], "coordinate", "array", coordinate_) &&
               one_of(pieces_[3], "real", "integer", ignored_) && one_of(pieces_[4], "general", "symmetric", general_);
    }

    /// Whether the piece is the first (is_first), the second, or neither: a complaint.
    bool one_of(const LinePiece& piece, const char* first, const char* second, bool& is_first) {
        const std::string word = lower(piece.text);
        is_first = word == first;
        if (is_first || word == second) return true;
        lines_.refuse(piece, quoted(piece) + " is neither `" + first + "` nor `" + second + "`");
        return false;
    }

    bool read_sizes() {
        if (!next()) {
            lines_.refuse_text("no line with the sizes of the matrix");
            return false;
        }
        const std::size_t expected = coordinate_ ? 3 : 2;
        if (pieces_.size() != expected) {
            lines_.refuse(pieces_.front(), std::to_string(expected) + " whole numbers are meant: rows, columns" +
                                               (coordinate_ ? " and entries" : ""));
            return false;
        }
        std::uint64_t rows = 0;
        std::uint64_t columns = 0;
        if (!read_size(pieces_[0], max_matrix_side, "rows", rows)) return false;
        if (!read_size(pieces_[1], max_matrix_side, "columns", columns)) return false;
        if (!general_ && rows != columns) {
            lines_.refuse(pieces_[1], "a symmetric matrix has as many columns as rows");
            return false;
        }
        matrix_.rows.resize(static_cast<std::size_t>(rows));
        matrix_.columns = static_cast<std::size_t>(columns);
        if (coordinate_) return read_size(pieces_[2], max_matrix_entries, "entries", expected_);
        expected_ = general_ ? rows * columns : rows * (rows + 1) / 2;
        return true;
    }

    bool read_size(const LinePiece& piece, std::uint64_t most, const char* what, std::uint64_t& size) {
        const std::optional<std::uint64_t> value = count(piece.text);
        const bool may_be_zero = what == std::string_view("entries");
        if (value && *value <= most && (*value > 0 || may_be_zero)) {
            size = *value;
            return true;
        }
        lines_.refuse(piece, quoted(piece) + " is not a number of " + what + " from " + (may_be_zero ? "0" : "1") +
                                 " to " + std::to_string(most) + ", the limit");
        return false;
    }

    void read_entries() {
        std::uint64_t read = 0;
        for (; next(); ++read) {
            if (lines_.errors().size() >= max_polygon_errors || full_) return;
            if (read == expected_) {
                lines_.refuse(pieces_.front(), "more entries than the " + std::to_string(expected_) + " announced");
                return;
            }
            coordinate_ ? read_coordinate() : read_value(read);
        }
        if (read < expected_)
            lines_.refuse_text(std::to_string(read) + " entries, but " + std::to_string(expected_) + " are announced");
    }

    void read_coordinate() {
        if (refuse_length(3)) return;
        std::uint64_t row = 0;
        std::uint64_t column = 0;
        if (!read_index(pieces_[0], matrix_.rows.size(), "row", row)) return;
        if (!read_index(pieces_[1], matrix_.columns, "column", column)) return;
        const std::optional<Rational> value = fraction(lines_, pieces_[2]);
        if (value) store(row - 1, column - 1, *value);
    }

    /// Entry number `read` of an array: column after column, of a symmetric one the lower triangle.
    void read_value(std::uint64_t read) {
        assert(read < expected_ && row_ < matrix_.rows.size());
        if (read > 0 && ++row_ == matrix_.rows.size()) {
            ++column_;
            row_ = general_ ? 0 : column_;
        }
        if (refuse_length(1)) return;
        const std::optional<Rational> value = fraction(lines_, pieces_[0]);
        if (value) store(row_, column_, *value);
    }

    bool refuse_length(std::size_t expected) {
        for (const LinePiece& piece : pieces_)
            if (is_dots(piece.text)) {
                refuse_dots(lines_, piece);
                return true;
            }
        if (pieces_.size() == expected) return false;
        lines_.refuse(pieces_.back(),
                      expected == 3 ? "a row, a column and a value are meant" : "one value a line is meant");
        return true;
    }

    bool read_index(const LinePiece& piece, std::size_t most, const char* what, std::uint64_t& index) {
        const std::optional<std::uint64_t> value = count(piece.text);
        if (value && *value >= 1 && *value <= most) {
            index = *value;
            return true;
        }
        lines_.refuse(piece, quoted(piece) + " is not a " + what + " from 1 to " + std::to_string(most));
        return false;
    }

    void store(std::uint64_t row, std::uint64_t column, const Rational& value) {
        assert(row < matrix_.rows.size() && column < matrix_.columns);
        if (!general_ && column > row) {
            lines_.refuse(pieces_[1], "an entry above the diagonal of a symmetric matrix",
                          "only the lower triangle is written");
            return;
        }
        const auto i = static_cast<std::size_t>(row);
        const auto j = static_cast<std::size_t>(column);
        matrix_.rows[i].push_back({j, value});
        if (!general_ && i != j) matrix_.rows[j].push_back({i, value});
        entries_ += general_ || i == j ? 1 : 2;
        if (entries_ <= max_matrix_entries) return;
        lines_.refuse(pieces_.front(), "more than " + std::to_string(max_matrix_entries) + " entries, the limit");
        full_ = true;
    }

    /// Ascending columns, no zeros, no place twice.
    void order_rows() {
        for (std::size_t i = 0; i < matrix_.rows.size(); ++i) {
            RationalRow& row = matrix_.rows[i];
            std::ranges::stable_sort(row, {}, &RationalEntry::column);
            const auto twice = std::ranges::adjacent_find(row, {}, &RationalEntry::column);
            if (twice != row.end()) {
                lines_.refuse_text("row " + std::to_string(i + 1) + " has two entries in column " +
                                   std::to_string(twice->column + 1));
                return;
            }
            std::erase_if(row, [](const RationalEntry& entry) { return entry.value == 0; });
        }
    }

    TextLines lines_;
    std::vector<LinePiece> pieces_;
    bool coordinate_ = false;
    bool general_ = false;
    bool ignored_ = false; ///< real and integer are read alike
    bool full_ = false;
    std::uint64_t expected_ = 0; ///< entries announced
    std::uint64_t entries_ = 0;  ///< entries kept
    std::uint64_t row_ = 0;      ///< the row of the next value of an array
    std::uint64_t column_ = 0;
    RationalMatrix matrix_;
};

} // namespace

ParsedFractionMatrix read_fraction_matrix_market(std::string_view text, std::string_view source) {
    return MatrixMarketReader(text, source).read();
}

} // namespace internode
