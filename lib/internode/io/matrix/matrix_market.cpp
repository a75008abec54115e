// SPDX-License-Identifier: MIT

#include "internode/io/matrix/matrix_market.h"

#include "internode/io/file/comment_text.h"
#include "internode/io/file/text_buffer.h"

#include <stdexcept>

namespace internode {

bool write_matrix_market(Sink& sink, const MatrixView& matrix, std::span<const std::string> comments) {
    TextBuffer text(sink);
    text << "%%MatrixMarket matrix coordinate real general\n";
    for (const std::string& comment : comments) text << "% " << comment_text(comment) << '\n';
    text << matrix.rows << ' ' << matrix.columns << ' ' << matrix.entries.size() << '\n';
    for (const MatrixEntry& entry : matrix.entries) {
        if (entry.row >= matrix.rows || entry.column >= matrix.columns)
            throw std::out_of_range("write_matrix_market: an entry outside the matrix");
        text << entry.row + 1 << ' ' << entry.column + 1 << ' ' << entry.value;
        if (!text.end_line()) return false;
    }
    return text.flush();
}

} // namespace internode
