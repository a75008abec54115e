// SPDX-License-Identifier: MIT

#include "internode/io/matrix/fraction_matrix.h"

#include "internode/io/file/limits.h"
#include "internode/io/file/text_buffer.h"
#include "internode/io/matrix/fraction_entry.h"
#include "internode/text/lines.h"

#include <cassert>

namespace internode {

namespace {

char separator_of(std::string_view line) {
    for (const char separator : {';', ',', '\t'})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ' ';
}

LinePiece trimmed(std::string_view line, std::size_t begin, std::size_t end) {
    assert(begin <= end && end <= line.size());
    const std::size_t first = std::min(line.find_first_not_of(" \t", begin), end);
    const std::size_t last = first == end ? end : line.find_last_not_of(" \t", end - 1) + 1;
    return {line.substr(first, last - first), first};
}

std::vector<LinePiece> separated(std::string_view line, char separator) {
    if (separator == ' ') return blank_separated(line);
    std::vector<LinePiece> pieces;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        pieces.push_back(trimmed(line, begin, end));
        begin = end + 1;
    }
    return pieces;
}

class FractionReader {
public:
    FractionReader(std::string_view text, std::string_view source)
        : lines_(text, source, "matrix.unexpected") {}

    ParsedFractionMatrix read() && {
        while (lines_.errors().size() < max_polygon_errors && !full_ && lines_.next()) read_line();
        if (matrix_.rows.empty() && lines_.errors().empty())
            lines_.refuse_text("no row of a matrix", "write a row a line: 3/4, 1/4, 0");
        if (!lines_.errors().empty()) return {.matrix = {}, .errors = std::move(lines_.errors())};
        return {.matrix = std::move(matrix_), .errors = {}};
    }

private:
    void read_line() {
        const std::string_view line = lines_.line().substr(0, lines_.line().find('#'));
        const LinePiece content = trimmed(line, 0, line.size());
        if (content.text.empty()) return;
        if (separator_ == '\0' && !is_dots(content.text)) separator_ = separator_of(content.text);
        const std::vector<LinePiece> pieces = separated(line, separator_ == '\0' ? ' ' : separator_);
        for (const LinePiece& piece : pieces)
            if (is_dots(piece.text)) return refuse_dots(lines_, piece);
        if (matrix_.columns == 0 && !begin_matrix(pieces)) return;
        if (pieces.size() != matrix_.columns) return refuse_length(pieces);
        read_row(pieces);
    }

    bool begin_matrix(const std::vector<LinePiece>& pieces) {
        if (pieces.size() > max_matrix_side) {
            lines_.refuse(pieces[max_matrix_side],
                          "more than " + std::to_string(max_matrix_side) + " columns, the limit");
            full_ = true;
        }
        matrix_.columns = pieces.size();
        return !full_;
    }

    void read_row(const std::vector<LinePiece>& pieces) {
        assert(pieces.size() == matrix_.columns);
        if (matrix_.rows.size() == max_matrix_side) {
            lines_.refuse(pieces.front(), "more than " + std::to_string(max_matrix_side) + " rows, the limit");
            full_ = true;
            return;
        }
        RationalRow& row = matrix_.rows.emplace_back();
        for (std::size_t column = 0; column < pieces.size(); ++column) {
            const std::optional<Rational> value = fraction(lines_, pieces[column]);
            if (!value) return;
            if (*value == 0) continue;
            if (++entries_ > max_matrix_entries) return refuse_entries(pieces[column]);
            row.push_back({column, *value});
        }
    }

    void refuse_length(const std::vector<LinePiece>& pieces) {
        assert(!pieces.empty());
        lines_.refuse(pieces.back(),
                      std::to_string(pieces.size()) + (pieces.size() == 1 ? " entry" : " entries") +
                          ", but the first row has " + std::to_string(matrix_.columns),
                      "entries are separated by " + separator_name() +
                          " here, as in the first row; `,`, `;`, tabs and blanks are understood");
    }

    void refuse_entries(const LinePiece& piece) {
        lines_.refuse(piece, "more than " + std::to_string(max_matrix_entries) + " entries that are not 0, the limit");
        full_ = true;
    }

    [[nodiscard]] std::string separator_name() const {
        if (separator_ == ' ') return "blanks";
        return separator_ == '\t' ? std::string("tabs") : std::string{'`', separator_, '`'};
    }

    TextLines lines_;
    char separator_ = '\0'; ///< none before the first row
    std::uint64_t entries_ = 0;
    bool full_ = false; ///< a limit is reached: the rest is not read
    RationalMatrix matrix_;
};

} // namespace

ParsedFractionMatrix read_fraction_csv(std::string_view text, std::string_view source) {
    return FractionReader(text, source).read();
}

ParsedFractionMatrix read_fraction_matrix(std::string_view text, std::string_view source) {
    const std::size_t first = std::min(text.find_first_not_of("\xEF\xBB\xBF \t\r\n"), text.size());
    return text.substr(first).starts_with("%%") ? read_fraction_matrix_market(text, source)
                                                : read_fraction_csv(text, source);
}

bool write_fraction_csv(Sink& sink, const RationalMatrix& matrix) {
    TextBuffer text(sink);
    for (const RationalRow& row : matrix.rows) {
        std::size_t next = 0;
        for (std::size_t column = 0; column < matrix.columns; ++column) {
            if (column > 0) text << ", ";
            const bool stored = next < row.size() && row[next].column == column;
            text << (stored ? to_string(row[next].value) : std::string("0"));
            if (stored) ++next;
        }
        assert(next == row.size() && "entries ascend by column");
        if (!text.end_line()) return false;
    }
    return text.flush();
}

} // namespace internode
