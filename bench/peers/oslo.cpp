// SPDX-License-Identifier: MIT

#include "bench/peers/oslo.h"

namespace internode::bench {

CubicRows cubic_rows(std::span<const double> coarse, std::span<const double> fine) {
    constexpr std::size_t degree = 3;
    const std::size_t count = fine.size() - degree - 1;
    const std::size_t last_piece = coarse.size() - degree - 2;
    CubicRows rows;
    rows.first.reserve(count);
    rows.weights.resize(count * (degree + 1));
    std::size_t piece = degree;
    for (std::size_t j = 0; j < count; ++j) {
        while (piece < last_piece && coarse[piece + 1] <= fine[j]) ++piece;
        double* const b = &rows.weights[j * (degree + 1)];
        b[0] = 1;
        for (std::size_t k = 1; k <= degree; ++k) {
            double carried = 0;
            for (std::size_t i = 0; i < k; ++i) {
                const double low = coarse[piece - k + 1 + i];
                const double high = coarse[piece + 1 + i];
                const double share = b[i] / (high - low);
                b[i] = carried + (high - fine[j + k]) * share;
                carried = (fine[j + k] - low) * share;
            }
            b[k] = carried;
        }
        rows.first.push_back(piece - degree);
    }
    return rows;
}

} // namespace internode::bench
