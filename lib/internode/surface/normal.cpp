// SPDX-License-Identifier: MIT
//
// Tangents are taken times the weight w, which keeps their direction: A_u - w_u S. One whose coordinates lie within the
// noise of their terms counts as 0; the mixed derivative takes its place, with the sign of the side from which the
// surface comes.

#include "internode/surface/normal.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

double largest(const Vector3& a) {
    return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

Vector3 scaled(const Vector3& a, double factor) {
    return {a[0] * factor, a[1] * factor, a[2] * factor};
}

Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using Long3 = std::array<DoubleDouble, 3>;

Vector3 rounded(const Long3& a) {
    return {a[0].hi, a[1].hi, a[2].hi};
}

/// Derivatives of A / w from those of A and w, each times w > 0, which no direction minds.
class Tangents {
public:
    explicit Tangents(const LocalSurface& surface)
        : surface_(surface)
        , rational_(surface.position.size() == 4) {}

    [[nodiscard]] Long3 u() const { return first(surface_.along_u); }
    [[nodiscard]] Long3 v() const { return first(surface_.along_v); }

    /// A_uv - w_uv S - w_u S_v - w_v S_u.
    [[nodiscard]] Long3 mixed() const {
        Long3 result = first(surface_.mixed);
        if (!rational_) return result;
        const Long3 du = u();
        const Long3 dv = v();
        const DoubleDouble w = surface_.position[3];
        for (std::size_t c = 0; c < 3; ++c)
            result[c] = result[c] - (surface_.along_u[3] * dv[c] + surface_.along_v[3] * du[c]) / w;
        return result;
    }

private:
    /// A_u - w_u S.
    [[nodiscard]] Long3 first(std::span<const DoubleDouble> derivative) const {
        Long3 result{derivative[0], derivative[1], derivative[2]};
        if (!rational_) return result;
        const DoubleDouble slope = derivative[3] / surface_.position[3];
        for (std::size_t c = 0; c < 3; ++c) result[c] = result[c] - slope * surface_.position[c];
        return result;
    }

    const LocalSurface& surface_;
    bool rational_;
};

/// A tangent, and below which size its coordinates say nothing.
struct Tangent {
    Vector3 vector;
    double noise;
    [[nodiscard]] bool exists() const { return largest(vector) > noise; }
};

/// a × b of length 1; 0 where that is lost in the noise of a and b.
Vector3 direction(const Tangent& a, const Tangent& b) {
    if (!a.exists() || !b.exists()) return {};
    const double size_a = largest(a.vector);
    const double size_b = largest(b.vector);
    const Vector3 product = cross(scaled(a.vector, 1 / size_a), scaled(b.vector, 1 / size_b));
    const double size = largest(product);
    if (size <= 4 * (a.noise / size_a + b.noise / size_b)) return {}; // parallel, as far as can be known
    const Vector3 normal = scaled(product, 1 / size);
    return scaled(normal, 1 / std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]));
}

} // namespace

Vector3 unit_normal(const LocalSurface& surface) {
    assert(surface.along_u.size() == surface.position.size() && surface.along_v.size() == surface.position.size());
    assert(surface.position.size() == 3 || surface.position.size() == 4);
    assert(surface.mixed.size() == surface.position.size());
    assert(surface.noise_u >= 0 && surface.noise_v >= 0);
    const Tangents tangents(surface);
    const Tangent u{rounded(tangents.u()), surface.noise_u};
    const Tangent v{rounded(tangents.v()), surface.noise_v};
    if (u.exists() == v.exists()) return u.exists() ? direction(u, v) : Vector3{};
    // A step h into the surface across the direction that vanishes turns 0 into h S_uv.
    const bool backwards = u.exists() ? surface.u_from_left : surface.v_from_left;
    const Tangent mixed{scaled(rounded(tangents.mixed()), backwards ? -1 : 1), surface.noise_mixed};
    return u.exists() ? direction(u, mixed) : direction(mixed, v);
}

} // namespace internode
