// SPDX-License-Identifier: MIT
//
// One step backwards: fine polygon f (n_f points) = P c + Q e, coarse polygon c (n_c), details e (n_f - n_c vectors).
//
// c = A f with a left inverse A, A P = I: the least squares A = (PᵀP)^{-1} Pᵀ, or local filters. Every coarse point
// keeps one fine point (curve/reverse/kept_points.h); the others, one per inserted knot, carry the details. Here e is
// how far they lie from where the kept points alone would put them, and Q = (I - P A) restricted to their columns. Then
//
//     f = P (c - A e) + e        (e filled up with zeros at the kept points)
//
// for any such A. Under least squares Q is an orthogonal projection: |Q e| <= |e|, so a detail left out moves the fine
// polygon by at most its own length in the sum of squares. Everything is linear in n_f.

#pragma once

#include "internode/curve/reverse/details.h"
#include "internode/curve/reverse/hierarchy.h"
#include "internode/curve/reverse/local_filters.h"
#include "internode/curve/reverse/normal_equations.h"

#include <optional>

namespace internode {

/// The kept rows of P: n_c x n_c, regular.
struct KeptRows {
    GatherMatrix matrix;
    NormalEquations equations;
};

class ReverseStep {
public:
    /// From level + 1 down to level. The hierarchy must outlive the step.
    ReverseStep(const Hierarchy& hierarchy, int level, const ReverseOptions& options = {});

    /// Factorises beforehand what details() needs beside coarse(): it does so itself otherwise.
    void prepare_details();

    [[nodiscard]] std::size_t coarse_size() const { return matrix_.columns; }
    [[nodiscard]] std::size_t fine_size() const { return matrix_.rows.size(); }
    /// The fine points that stand for the inserted knots, ascending: n_f - n_c of them.
    [[nodiscard]] const std::vector<std::size_t>& inserted() const { return inserted_; }

    /// c = A f. Points are rows of `dimension` numbers here and below. \throw std::invalid_argument for other sizes
    [[nodiscard]] std::vector<double> coarse(std::span<const double> fine, std::size_t dimension) const;
    /// e, one vector per inserted point, of f and its c. \throw as coarse()
    [[nodiscard]] Details details(std::span<const double> fine, std::span<const double> coarse,
                                  std::size_t dimension) const;
    /// f of c and e, which may have fewer vectors than there are inserted points. \throw as coarse(), and
    /// std::out_of_range for a detail at a point that is not there
    [[nodiscard]] std::vector<double> fine(std::span<const double> coarse, const Details& details,
                                           std::size_t dimension) const;

private:
    GatherMatrix matrix_;
    bool identity_;
    std::vector<std::size_t> kept_;
    std::vector<std::size_t> inserted_;
    std::optional<NormalEquations> equations_; ///< the equations of the least squares
    std::optional<KeptRows> kept_rows_;        ///< once details are prepared
    std::optional<LocalFilters> filters_;
};

} // namespace internode
