// SPDX-License-Identifier: MIT
//
// Eigen's sparse matrix from the coarse points to the fine ones, built once and multiplied by points in space.

#pragma once

#include "bench/peers/oslo.h"

#include <memory>

namespace internode::bench {

class SparseRefinement {
public:
    SparseRefinement(const CubicRows& rows, std::size_t coarse_count);
    ~SparseRefinement();
    SparseRefinement(const SparseRefinement&) = delete;
    SparseRefinement& operator=(const SparseRefinement&) = delete;

    void apply(std::span<const double> points, std::span<double> out) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace internode::bench
