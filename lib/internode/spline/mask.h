// SPDX-License-Identifier: MIT
//
// Masks (Nivoliers et al. 2012, 2.2): how one control point scatters into the next step.
//
// The basis function of decomposition w = w_1 … w_{d+1} is a combination of the basis functions of the |σ(w)| - d
// factors of σ(w) of length d+1, by position: B_w = Σ_l weight_l B'_l. Weights are >= 0 and exact in K.

#pragma once

#include "internode/interval/interval_system.h"

#include <vector>

namespace internode {

struct MaskEntry {
    Word word;     ///< d + 1 letters: the decomposition of the new control point
    Number weight; ///< the share of the old basis function, in [0, 1]
};

struct Mask {
    Word word;                      ///< d + 1 letters, not all `0`
    std::vector<MaskEntry> entries; ///< |σ(w)| - d, left to right
};

/// The mask of one decomposition, by blossoming. \throw std::invalid_argument for a word of fewer than two letters, of
/// zero length, or with a symbol that has no length.
[[nodiscard]] Mask mask(const IntervalSystem& system, WordView word);

} // namespace internode
