// SPDX-License-Identifier: MIT
//
// SISL's s1018: all knots into a cubic curve in space at once.

#pragma once

#include <memory>
#include <span>
#include <vector>

namespace internode::bench {

class SislRefinement {
public:
    SislRefinement(std::vector<double> knots, std::vector<double> points, std::vector<double> inserted);
    ~SislRefinement();
    SislRefinement(const SislRefinement&) = delete;
    SislRefinement& operator=(const SislRefinement&) = delete;

    /// The refined points, until the next call. \throw std::runtime_error when SISL says no
    std::span<const double> refine();
    /// Gives the memory of the last result back.
    void release();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace internode::bench
