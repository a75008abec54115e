// SPDX-License-Identifier: MIT
//
// A left inverse A of a step, A P = I, by local filters: every coarse point from the fine points around it.
//
// The fine points whose support meets a window of m old intervals depend on the m + d old points whose support does,
// and on no others. P restricted to them is a step of an open curve whose domain is the window, of full column rank.
// The filter of a coarse point is its row of the pseudo-inverse of that restriction: among all filters on these fine
// points that reproduce it the one of least norm. The window is centred in the support of the point, inside the domain.

#pragma once

#include "internode/curve/reverse/hierarchy.h"

namespace internode {

class LocalFilters {
public:
    /// Windows of `window` >= 1 intervals with a length (fewer where an open domain has fewer); equal windows share
    /// their filter. The matrix is the hierarchy's of that level.
    LocalFilters(const Hierarchy& hierarchy, int level, const GatherMatrix& matrix, std::size_t window);

    /// A x: n_c rows of `dimension` numbers from n_f.
    [[nodiscard]] std::vector<double> apply(std::span<const double> fine, std::size_t dimension) const;
    /// How many different filters there are.
    [[nodiscard]] std::size_t count() const { return filters_.size(); }

private:
    struct Place {
        std::ptrdiff_t first = 0; ///< fine point of the first weight, modulo their number
        std::size_t filter = 0;
    };
    std::size_t fine_size_ = 0;
    std::vector<Place> places_;                ///< the filter of each coarse point
    std::vector<std::vector<double>> filters_; ///< weights of consecutive fine points
};

} // namespace internode
