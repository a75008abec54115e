// SPDX-License-Identifier: MIT

#include "internode/surface/normal.h"

#include <algorithm>
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

/// Derivatives of A / w from those of A and w, each times w > 0, which no direction minds.
class Tangents {
public:
    explicit Tangents(const LocalSurface& surface)
        : surface_(surface)
        , rational_(surface.position.size() == 4) {}

    [[nodiscard]] Vector3 u() const { return first(surface_.along_u); }
    [[nodiscard]] Vector3 v() const { return first(surface_.along_v); }

    /// (A_uv - w_uv S - w_u S_v - w_v S_u).
    [[nodiscard]] Vector3 mixed() const {
        Vector3 result = first(surface_.mixed);
        if (!rational_) return result;
        const Vector3 du = u();
        const Vector3 dv = v();
        const double w = surface_.position[3];
        for (std::size_t c = 0; c < 3; ++c)
            result[c] -= (surface_.along_u[3] * dv[c] + surface_.along_v[3] * du[c]) / w;
        return result;
    }

private:
    /// A_u - w_u S.
    [[nodiscard]] Vector3 first(std::span<const double> derivative) const {
        Vector3 result{derivative[0], derivative[1], derivative[2]};
        if (!rational_) return result;
        const double slope = derivative[3] / surface_.position[3];
        for (std::size_t c = 0; c < 3; ++c) result[c] -= slope * surface_.position[c];
        return result;
    }

    const LocalSurface& surface_;
    bool rational_;
};

/// a × b of length 1; 0 where that is lost in the noise of a and b.
Vector3 direction(const Vector3& a, const Vector3& b, double noise) {
    const double size_a = largest(a);
    const double size_b = largest(b);
    if (size_a <= noise || size_b <= noise) return {};
    const Vector3 product = cross(scaled(a, 1 / size_a), scaled(b, 1 / size_b));
    const double size = largest(product);
    if (size <= 4 * (noise / size_a + noise / size_b)) return {}; // parallel, as far as can be known
    const Vector3 normal = scaled(product, 1 / size);
    return scaled(normal, 1 / std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]));
}

} // namespace

Vector3 unit_normal(const LocalSurface& surface) {
    const Tangents tangents(surface);
    const Vector3 u = tangents.u();
    const Vector3 v = tangents.v();
    const bool has_u = largest(u) > surface.noise;
    const bool has_v = largest(v) > surface.noise;
    if (has_u == has_v) return has_u ? direction(u, v, surface.noise) : Vector3{};
    // A step h into the surface across the direction that vanishes turns 0 into h S_uv.
    const bool backwards = has_u ? surface.u_from_left : surface.v_from_left;
    const Vector3 mixed = scaled(tangents.mixed(), backwards ? -1 : 1);
    return has_u ? direction(u, mixed, surface.noise) : direction(mixed, v, surface.noise);
}

} // namespace internode
