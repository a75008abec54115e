// SPDX-License-Identifier: MIT

#include "bench/rows.h"

namespace internode::bench {

std::vector<Row> all_rows() {
    std::vector<Row> rows;
    for (auto* const part : {memory_rows, curve_rows, grid_rows, own_rows, point_rows, text_rows})
        for (Row& row : part()) rows.push_back(std::move(row));
    return rows;
}

} // namespace internode::bench
