// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/inner_point.h"

#include <cmath>
#include <vector>

namespace nmgs {
namespace {

struct Plane {
    Vec3 normal; // unit
    double offset;
    [[nodiscard]] double above(Vec3 x) const { return dot(normal, x) - offset; }
};

// Where the four planes are at the same distance t; none when that is not one point.
std::optional<Vec3> equidistant(const Plane &a, const Plane &b, const Plane &c, const Plane &d) {
    const Vec3 u = b.normal - a.normal;
    const Vec3 v = c.normal - a.normal;
    const Vec3 w = d.normal - a.normal;
    const double j = determinant(u, v, w);
    if (std::abs(j) < 1e-12) {
        return std::nullopt;
    }
    return (1 / j) * ((b.offset - a.offset) * cross(v, w) + (c.offset - a.offset) * cross(w, u) +
                      (d.offset - a.offset) * cross(u, v));
}

} // namespace

std::optional<Vec3> inner_point(std::span<const std::array<Vec3, 3>> triangles) {
    if (triangles.empty()) {
        return std::nullopt;
    }
    const Vec3 origin = triangles[0][0]; // keeps digits far from the origin
    std::vector<Plane> planes;
    for (const auto &t : triangles) {
        const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
        const double length = norm(n);
        if (!(length > 0)) {
            return std::nullopt;
        }
        const Vec3 unit = (1 / length) * n;
        planes.push_back({unit, dot(unit, t[0] - origin)});
    }
    std::optional<Vec3> best;
    double best_distance = 0;
    const std::size_t n = planes.size();
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            for (std::size_t c = b + 1; c < n; ++c) {
                for (std::size_t d = c + 1; d < n; ++d) {
                    const auto x = equidistant(planes[a], planes[b], planes[c], planes[d]);
                    if (!x) {
                        continue;
                    }
                    double least = planes[a].above(*x);
                    for (const Plane &plane : planes) {
                        least = std::fmin(least, plane.above(*x));
                    }
                    if (least > best_distance) {
                        best_distance = least;
                        best = *x + origin;
                    }
                }
            }
        }
    }
    return best;
}

} // namespace nmgs
