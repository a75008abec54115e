// SPDX-License-Identifier: MIT
//
// A matrix of exact numbers as a file gives it. Fractions and decimals are read exactly: 3/4 and 0.75 are the same.
//
// CSV: a row a line, `,`, `;`, tabs or blanks between the entries (the first row decides), `#` begins a comment, empty
// lines, CR LF, a byte order mark. MatrixMarket: coordinate or array, real or integer, general or symmetric; values may
// be fractions. Dots (`...`, `:`, `⋮`, `⋱`) stand for entries that only a reader can supply (Prusinkiewicz et al. 2003,
// section 5): they are complained about, each line once, with their places.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/io/file/sink.h"
#include "internode/text/diagnostic.h"

#include <optional>
#include <string_view>
#include <vector>

namespace internode {

struct ParsedFractionMatrix {
    std::optional<RationalMatrix> matrix; ///< present iff errors is empty; at least one row and one column
    std::vector<Diagnostic> errors;       ///< errors in the order of the text, at most max_polygon_errors
};

/// All three never throw on any text (but std::bad_alloc). Cost: linear in the text, times log of a row's entries.
/// Limits: io/file/limits.h.
[[nodiscard]] ParsedFractionMatrix read_fraction_csv(std::string_view text, std::string_view source);
[[nodiscard]] ParsedFractionMatrix read_fraction_matrix_market(std::string_view text, std::string_view source);

/// One of the two: a text that begins with `%%MatrixMarket` is one.
[[nodiscard]] ParsedFractionMatrix read_fraction_matrix(std::string_view text, std::string_view source);

/// All entries as fractions, a row a line, `, ` between them. False if the sink failed.
bool write_fraction_csv(Sink& sink, const RationalMatrix& matrix);

} // namespace internode
