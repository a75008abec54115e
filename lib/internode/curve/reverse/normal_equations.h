// SPDX-License-Identifier: MIT
//
// The normal equations PᵀP x = Pᵀ b of a gather matrix, by L D Lᵀ in envelope storage.
//
// Row k of the lower triangle is kept from its first entry on: d numbers a row of a band. The last d rows of a closed
// curve reach back to its first point and fill. No fill beyond the envelope, no pivoting (PᵀP is positive definite),
// sums in a fixed order. Memory O(n d), time O(n d^2).

#pragma once

#include "internode/curve/reverse/gather_matrix.h"

namespace internode {

class NormalEquations {
public:
    /// Factorises PᵀP.
    explicit NormalEquations(const GatherMatrix& matrix);

    /// Whether every pivot stayed well above rounding: false when P has no full column rank.
    [[nodiscard]] bool regular() const { return regular_; }
    /// (PᵀP)^{-1} applied to n_c rows of `dimension` numbers, in place.
    void solve(std::vector<double>& rows, std::size_t dimension) const;

private:
    void add(const GatherMatrix& matrix);
    void factorise();
    [[nodiscard]] double& entry(std::size_t row, std::size_t column) {
        return lower_[start_[row] + (column - first_[row])];
    }

    bool regular_ = true;
    std::vector<std::size_t> first_; ///< column of the first entry of each row
    std::vector<std::size_t> start_; ///< where each row begins in lower_; n + 1 of them
    std::vector<double> lower_;      ///< rows first_[k] … k - 1 of L
    std::vector<double> diagonal_;   ///< D
};

/// The x that makes |P x - b| least, P of full column rank; refined twice with the residual, so that the squared
/// condition of the normal equations costs no accuracy.
[[nodiscard]] std::vector<double> least_squares(const GatherMatrix& matrix, const NormalEquations& equations,
                                                std::span<const double> b, std::size_t dimension);

} // namespace internode
