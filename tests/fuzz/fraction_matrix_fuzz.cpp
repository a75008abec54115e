// SPDX-License-Identifier: MIT
//
// Any text as a matrix: refused with places, or accepted and then the same after being written and read again.

#include "internode/io/matrix/fraction_matrix.h"
#include "internode/text/diagnostic.h"
#include "tests/fuzz/require.h"

#include <cstdint>

using internode::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace internode;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedFractionMatrix parsed = read_fraction_matrix(text, "fuzz.csv");
    require(parsed.matrix.has_value() == parsed.errors.empty());
    if (!parsed.matrix) {
        require(!to_string(parsed.errors).empty());
        return 0;
    }
    const RationalMatrix& matrix = *parsed.matrix;
    require(matrix.columns >= 1 && !matrix.rows.empty());
    for (const RationalRow& row : matrix.rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            require(row[i].column < matrix.columns && row[i].value != 0);
            require(i == 0 || row[i - 1].column < row[i].column);
        }
    constexpr std::size_t most_written = 100'000; // a text of a few bytes may announce a matrix of 10^12 zeros
    if (matrix.rows.size() > most_written / matrix.columns) return 0;
    StringSink sink;
    require(write_fraction_csv(sink, matrix));
    const ParsedFractionMatrix again = read_fraction_csv(sink.text(), "again.csv");
    constexpr std::size_t few_digits = 100; // a value of 10^400 is written with more digits than the reader takes
    require((again.matrix && *again.matrix == matrix) || sink.text().size() > few_digits);
    return 0;
}
