// SPDX-License-Identifier: MIT
//
// Curves of many degrees and dimensions that all have about as many bytes: for a fill to be compared with them.

#pragma once

#include "bench/cases.h"

#include "internode/curve/refinement.h"

#include <cmath>
#include <string>
#include <vector>

namespace internode::bench {

struct ByteCase {
    std::string name;
    int degree;
    std::size_t dimension;
    bool in_float;
    std::size_t count; ///< of control points
    int steps;
};

/// Clamped Fibonacci curves of as many bytes as `count` control points of three doubles become, about.
[[nodiscard]] inline std::vector<ByteCase> byte_cases(std::size_t count, int steps) {
    std::vector<ByteCase> cases;
    for (const int degree : {2, 3, 5, 12})
        cases.push_back({"degree-" + std::to_string(degree), degree, 3, false, count, steps});
    for (const std::size_t size : {2, 4, 7})
        cases.push_back({std::to_string(size) + "-D", 3, size, false, count * 3 / size, steps});
    cases.push_back({"float", 3, 3, true, count * 2, steps});
    return cases;
}

template<typename Scalar>
struct ByteCurve {
    explicit ByteCurve(const ByteCase& given)
        : knots(prefix_knots(bundled_system("fibonacci"), given.degree, Shape::Clamped, given.count))
        , dimension(given.dimension)
        , steps(given.steps) {
        for (std::size_t i = 0; i < given.count * dimension; ++i)
            points.push_back(static_cast<Scalar>(std::sin(0.37 * static_cast<double>(i))));
    }
    [[nodiscard]] RefinementPlan plan() const { return refinement_plan(knots, steps); }

    Knots knots;
    std::size_t dimension;
    int steps;
    std::vector<Scalar> points{};
};

} // namespace internode::bench
