// SPDX-License-Identifier: MIT
//
// A B-spline curve: knots (curve/knots.h) and control points, one for each of them that the knots ask for.

#pragma once

#include "internode/curve/knots.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct ApplyOptions;
struct CurveData;
struct CheckedCurve;

class Curve {
public:
    [[nodiscard]] const Knots& knots() const { return knots_; }
    [[nodiscard]] const IntervalSystem& system() const { return knots_.system(); }
    [[nodiscard]] int degree() const { return knots_.degree(); }
    [[nodiscard]] Ends ends() const { return knots_.ends(); }
    [[nodiscard]] const Word& word() const { return knots_.word(); }
    [[nodiscard]] int step() const { return knots_.step(); }
    [[nodiscard]] WordView domain() const { return knots_.domain(); }
    [[nodiscard]] std::size_t dimension() const { return dimension_; }
    /// size() rows of dimension() coordinates.
    [[nodiscard]] const std::vector<double>& points() const { return points_; }
    [[nodiscard]] std::size_t size() const { return points_.size() / dimension_; }

private:
    friend class Refinement;
    friend Curve refine(const Curve& curve, int steps, const ApplyOptions& options);
    friend CheckedCurve make_curve(const IntervalSystem& system, CurveData data);
    friend CheckedCurve make_curve(Knots knots, std::size_t dimension, std::vector<double> points);
    Curve(Knots knots, std::size_t dimension, std::vector<double> points);
    Knots knots_;
    std::size_t dimension_;
    std::vector<double> points_;
};

struct CurveData {
    int degree = 3; ///< 1 … 12
    Ends ends = Ends::Open;
    Word word;
    std::size_t dimension = 2;  ///< >= 1
    std::vector<double> points; ///< whole rows of `dimension` coordinates
    Number origin{};            ///< where the parameter of the domain begins
};

struct CheckedCurve {
    std::optional<Curve> curve;        ///< the curve, when everything fits
    std::vector<std::string> problems; ///< what does not fit, each a sentence with the numbers
};

/// Checks sizes, the knots as make_knots() does, and that every coordinate is finite. At most a few problems of each
/// kind are listed.
[[nodiscard]] CheckedCurve make_curve(const IntervalSystem& system, CurveData data);

/// Points over knots already checked, at any step: as many as the knots ask for, finite.
[[nodiscard]] CheckedCurve make_curve(Knots knots, std::size_t dimension, std::vector<double> points);

} // namespace internode
