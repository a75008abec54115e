// SPDX-License-Identifier: MIT
//
// Which published schemes a mask is, whatever the grammar calls itself: compared coefficient by coefficient, up to a
// shift of the new points.
//
// The masks are derived, not stored: B-splines of degree d are s(z)^{d+1} / m^d (Lane and Riesenfeld 1980 for m = 2).
// The 2n-point schemes are Lagrange's weights of 2n neighbours at 1/2 (Deslauriers and Dubuc 1989; n = 2: Dyn, Levin
// and Gregory 1987). Their dual relatives are those at 1/4 and 3/4 (n = 2: Dyn, Floater and Hormann 2005). Families are
// recognised by solving for their parameter.

#pragma once

#include "internode/mask/uniform_mask.h"

#include <string>
#include <vector>

namespace internode {

enum class SchemeFamily {
    BSpline,        ///< parameter: the degree
    LaneRiesenfeld, ///< parameter: the number of averaging rounds, degree - 1
    Chaikin,
    CornerCutting,    ///< parameters: where the two new points stand on an edge
    FourPoint,        ///< parameter: the tension w
    SixPoint,         ///< Weissman's family; parameter: θ
    DeslauriersDubuc, ///< parameter: the number of points 2n
    DualInterpolation ///< parameter: the number of points 2n
};

struct KnownScheme {
    SchemeFamily family = SchemeFamily::BSpline;
    std::vector<Rational> parameters;
    std::string name; ///< "uniform cubic B-spline", "4-point scheme with tension w = 1/16"
};

/// All that it is, the most general name first; empty when it is none. \throw std::invalid_argument as mask_properties
[[nodiscard]] std::vector<KnownScheme> known_schemes(const UniformMask& mask);

/// Lagrange's weights of the points 1-n … n at the place x, in this order.
[[nodiscard]] std::vector<Rational> lagrange_weights(std::size_t n, const Rational& x);

} // namespace internode
