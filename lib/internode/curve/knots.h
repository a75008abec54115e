// SPDX-License-Identifier: MIT
//
// The knot side of a B-spline: knot intervals labelled by symbols of a valid interval system, and the degree.
//
// Point k has the support word[k] … word[k+d] (0-based). Open: N points, N + d letters, domain = letters d … N-1;
// closed: N points, N letters, circular. `0` is an empty interval: a run of z of them is a knot of multiplicity z+1;
// d in a row end a clamped curve or break it, d+1 are refused. At step s the interval A_i has length a_i / ρ^s.
// Only make_knots() and refinement make one: curves and both directions of a grid hold one and need not check again.

#pragma once

#include "internode/interval/interval_system.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct KnotsData;
struct CheckedKnots;

class Knots {
public:
    [[nodiscard]] const IntervalSystem& system() const { return system_; }
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] Ends ends() const { return ends_; }
    [[nodiscard]] const Word& word() const { return word_; }
    /// How many steps the lengths have been divided by ρ.
    [[nodiscard]] int step() const { return step_; }
    /// The parameter where the domain begins: the same at every step, which moves no knot that was there.
    [[nodiscard]] const Number& origin() const { return origin_; }
    /// N, the number of control points.
    [[nodiscard]] std::size_t size() const;
    /// The letters of the domain: all of a closed word, letters d … N-1 of an open one.
    [[nodiscard]] WordView domain() const;

private:
    friend CheckedKnots make_knots(const IntervalSystem& system, KnotsData data);
    friend Knots refined_knots(const Knots& knots, int steps);
    Knots(IntervalSystem system, KnotsData data);
    IntervalSystem system_;
    int degree_;
    Ends ends_;
    Word word_;
    Number origin_;
    int step_ = 0;
};

struct KnotsData {
    int degree = 3; ///< 1 … 12
    Ends ends = Ends::Open;
    Word word;       ///< N letters closed, N >= 1; N + d open, N > d
    Number origin{}; ///< t_d of an open curve, t_0 of a closed one: rational, or in the field of the system
};

struct CheckedKnots {
    std::optional<Knots> knots;        ///< the knots, when everything fits
    std::vector<std::string> problems; ///< what does not fit, each a sentence with the numbers
};

/// The lengths that a curve may have: a margin that keeps squares and quotients of lengths finite in doubles.
inline constexpr double smallest_length = 1e-150;
inline constexpr double largest_length = 1e150;
/// How far from 0 a domain may begin, for the same reason.
inline constexpr double largest_origin = 1e150;
inline constexpr int max_degree = 12;

/// Checks degree, size, letters and their lengths, runs of `0`, the origin, and that the domain begins and ends with a
/// length.
[[nodiscard]] CheckedKnots make_knots(const IntervalSystem& system, KnotsData data);

/// The word of a clamped curve: d zeros, the domain, d zeros.
[[nodiscard]] Word clamped(WordView domain, int degree);

/// The first `count` letters of word word word …; count letters of a non-empty word.
[[nodiscard]] Word repeated(WordView word, std::size_t count);

} // namespace internode
