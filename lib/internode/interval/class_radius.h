// SPDX-License-Identifier: MIT
//
// The spectral radius of each class of a system, exact or between certified bounds, and their order.
//
// Two exact radii are equal iff their minimal polynomials are: each is the largest real root of its own. Different ones
// are separated by bisection with rationals. Bounds decide only when they do not meet; never a tolerance.

#pragma once

#include "internode/interval/class_graph.h"
#include "internode/interval/quantity.h"

#include <compare>
#include <optional>
#include <vector>

namespace internode {

struct ClassRadius {
    Quantity value;                   ///< exact when its field's degree is within the limit
    std::optional<NumberField> field; ///< Q(ρ) whenever ρ is known, of any degree
    bool pisot = false;               ///< only with a field
    std::size_t block = 0;            ///< equal for classes with the same block
};

struct RadiusLimits {
    std::size_t exact_class = 200;
    std::size_t field_degree = 32;
};

/// The radii of all classes: exact for rules of one length inside the class (ratio 0, 1, a single symbol …), bounds for
/// the others. Then exact within the limits where it matters: for the largest and for all that meet it.
[[nodiscard]] std::vector<ClassRadius> class_radii(const ClassGraph& graph, const RadiusLimits& limits);

/// `unordered` when it cannot be told.
[[nodiscard]] std::partial_ordering compare(const ClassRadius& a, const ClassRadius& b);

/// A class that no other is known to exceed, and how the others stand to it.
struct LargestRadius {
    std::size_t index = 0;
    std::vector<std::partial_ordering> order; ///< how each class stands to the largest: less, equivalent or unordered
};
/// \throw std::invalid_argument for no radii
[[nodiscard]] LargestRadius largest_radius(const std::vector<ClassRadius>& radii);

} // namespace internode
