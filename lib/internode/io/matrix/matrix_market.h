// SPDX-License-Identifier: MIT
//
// A sparse matrix as a MatrixMarket file: coordinate real general, indices from 1, shortest round-trip numbers.

#pragma once

#include "internode/io/file/sink.h"

#include <cstddef>
#include <span>
#include <string>

namespace internode {

struct MatrixEntry {
    std::size_t row = 0;    ///< from 0
    std::size_t column = 0; ///< from 0
    double value = 0;
};

struct MatrixView {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::span<const MatrixEntry> entries{}; ///< written in this order; no place twice
};

/// Writes the matrix; false if the sink failed. `comments` come after the banner, a line each.
/// \throw std::out_of_range for an entry outside the matrix; std::invalid_argument for a value that is not finite
bool write_matrix_market(Sink& sink, const MatrixView& matrix, std::span<const std::string> comments = {});

} // namespace internode
