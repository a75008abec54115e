// SPDX-License-Identifier: MIT
//
// A B-spline curve whose knot intervals are labelled by symbols of a valid interval system.
//
// Point k has the support word[k] … word[k+d] (0-based). Open: N points, N + d letters, domain = letters d … N-1;
// closed: N points, N letters, circular. `0` is an empty interval: a run of z of them is a knot of multiplicity z+1;
// d in a row end a clamped curve or break it, d+1 are refused. At step s the interval A_i has length a_i / ρ^s.

#pragma once

#include "internode/interval/interval_system.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct CurveData;
struct CheckedCurve;

class Curve {
public:
    [[nodiscard]] const IntervalSystem& system() const { return system_; }
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] Ends ends() const { return ends_; }
    [[nodiscard]] const Word& word() const { return word_; }
    /// How many steps the lengths have been divided by ρ.
    [[nodiscard]] int step() const { return step_; }
    [[nodiscard]] std::size_t dimension() const { return dimension_; }
    /// size() rows of dimension() coordinates.
    [[nodiscard]] const std::vector<double>& points() const { return points_; }
    [[nodiscard]] std::size_t size() const { return points_.size() / dimension_; }
    /// The letters of the domain: all of a closed word, letters d … N-1 of an open one.
    [[nodiscard]] WordView domain() const;

private:
    friend class Refinement;
    friend CheckedCurve make_curve(const IntervalSystem& system, CurveData data);
    Curve(IntervalSystem system, CurveData data);
    IntervalSystem system_;
    int degree_;
    Ends ends_;
    Word word_;
    std::size_t dimension_;
    std::vector<double> points_;
    int step_ = 0;
};

struct CurveData {
    int degree = 3; ///< 1 … 12
    Ends ends = Ends::Open;
    Word word;
    std::size_t dimension = 2;  ///< >= 1
    std::vector<double> points; ///< whole rows of `dimension` coordinates
};

struct CheckedCurve {
    std::optional<Curve> curve;        ///< when everything fits
    std::vector<std::string> problems; ///< what does not, each a sentence with the numbers
};

/// The lengths that a curve may have: a margin that keeps squares and quotients of lengths finite in doubles.
inline constexpr double smallest_length = 1e-150;
inline constexpr double largest_length = 1e150;
inline constexpr int max_degree = 12;

/// Checks sizes, letters and their lengths, runs of `0`, that the domain has a length, and that every coordinate is
/// finite. At most a few problems of each kind are listed.
[[nodiscard]] CheckedCurve make_curve(const IntervalSystem& system, CurveData data);

/// The word of a clamped curve: d zeros, the domain, d zeros.
[[nodiscard]] Word clamped(WordView domain, int degree);

/// The first `count` letters of word word word …; count letters of a non-empty word.
[[nodiscard]] Word repeated(WordView word, std::size_t count);

} // namespace internode
