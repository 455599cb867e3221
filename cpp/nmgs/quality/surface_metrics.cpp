// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/surface_metrics.h"

#include "nmgs/support/vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace nmgs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double root3 = std::numbers::sqrt3;
constexpr double degree = 180.0 / std::numbers::pi;

// Accurate for small angles too, where acos of a dot product is not (Kahan).
double angle(Vec3 a, Vec3 b) {
    return degree * std::atan2(norm(cross(a, b)), dot(a, b));
}

double ratio(double numerator, double denominator, double otherwise) {
    return denominator > 0 ? numerator / denominator : otherwise;
}

struct Sides {
    Vec3 a, b, c; // of the triangle: 0-1, 1-2, 2-0
    double twice_area;
    explicit Sides(const Vec3 *p)
        : a(p[1] - p[0]), b(p[2] - p[1]), c(p[0] - p[2]), twice_area(norm(cross(a, b))) {}
};

// Edges of a quadrilateral and twice the signed areas at its corners.
struct Corners {
    std::array<Vec3, 4> edge;
    std::array<double, 4> jacobian;
    explicit Corners(const Vec3 *p)
        : edge{p[1] - p[0], p[2] - p[1], p[3] - p[2], p[0] - p[3]}, jacobian{} {
        const Vec3 normal = unit(cross(edge[0] - edge[2], edge[1] - edge[3]));
        for (std::size_t i = 0; i < 4; ++i) {
            jacobian[i] = dot(normal, cross(edge[(i + 3) % 4], edge[i]));
        }
    }
};

} // namespace

namespace triangle {

double area(const Vec3 *p) {
    return 0.5 * Sides(p).twice_area;
}

double scaled_jacobian(const Vec3 *p) {
    const Sides s(p);
    const double a = norm(s.a);
    const double b = norm(s.b);
    const double c = norm(s.c);
    return 2 / root3 * ratio(s.twice_area, std::max({a * b, b * c, c * a}), 0);
}

double shape(const Vec3 *p) {
    const Sides s(p);
    return ratio(2 * root3 * s.twice_area, norm2(s.a) + norm2(s.b) + norm2(s.c), 0);
}

double aspect_ratio(const Vec3 *p) {
    const Sides s(p);
    const double a = norm(s.a);
    const double b = norm(s.b);
    const double c = norm(s.c);
    return ratio(std::max({a, b, c}) * (a + b + c), 2 * root3 * s.twice_area, infinity);
}

double min_angle(const Vec3 *p) {
    const Sides s(p);
    return std::min({angle(s.a, -1 * s.c), angle(s.b, -1 * s.a), angle(s.c, -1 * s.b)});
}

double max_angle(const Vec3 *p) {
    const Sides s(p);
    return std::max({angle(s.a, -1 * s.c), angle(s.b, -1 * s.a), angle(s.c, -1 * s.b)});
}

double radius_edge_ratio(const Vec3 *p) {
    const Sides s(p);
    const double a = norm(s.a);
    const double b = norm(s.b);
    const double c = norm(s.c);
    return ratio(a * b * c, 2 * s.twice_area * std::min({a, b, c}), infinity);
}

} // namespace triangle

namespace quad {

double area(const Vec3 *p) {
    const Corners q(p);
    return 0.25 * (q.jacobian[0] + q.jacobian[1] + q.jacobian[2] + q.jacobian[3]);
}

double scaled_jacobian(const Vec3 *p) {
    const Corners q(p);
    double least = infinity;
    for (std::size_t i = 0; i < 4; ++i) {
        const double lengths = norm(q.edge[i]) * norm(q.edge[(i + 3) % 4]);
        least = std::min(least, ratio(q.jacobian[i], lengths, 0));
    }
    return least;
}

double shape(const Vec3 *p) {
    const Corners q(p);
    double least = infinity;
    for (std::size_t i = 0; i < 4; ++i) {
        const double squares = norm2(q.edge[i]) + norm2(q.edge[(i + 3) % 4]);
        least = std::min(least, 2 * ratio(q.jacobian[i], squares, 0));
    }
    return std::max(0.0, least);
}

double aspect_ratio(const Vec3 *p) {
    const Corners q(p);
    double sum = 0;
    double longest = 0;
    for (const Vec3 &e : q.edge) {
        const double length = norm(e);
        sum += length;
        longest = std::max(longest, length);
    }
    const double twice_area = norm(cross(q.edge[0], q.edge[1])) + norm(cross(q.edge[2], q.edge[3]));
    return ratio(longest * sum, 2 * twice_area, infinity);
}

double skew(const Vec3 *p) {
    const Vec3 x = p[1] + p[2] - p[0] - p[3];
    const Vec3 y = p[2] + p[3] - p[0] - p[1];
    return std::abs(dot(unit(x), unit(y)));
}

double warpage(const Vec3 *p) {
    const Corners q(p);
    std::array<Vec3, 4> n{};
    for (std::size_t i = 0; i < 4; ++i) {
        n[i] = unit(cross(q.edge[(i + 3) % 4], q.edge[i]));
    }
    const double least = std::min(dot(n[0], n[2]), dot(n[1], n[3]));
    return 1 - least * least * least;
}

double min_angle(const Vec3 *p) {
    const Corners q(p);
    double least = infinity;
    for (std::size_t i = 0; i < 4; ++i) {
        least = std::min(least, angle(q.edge[i], -1 * q.edge[(i + 3) % 4]));
    }
    return least;
}

double max_angle(const Vec3 *p) {
    const Corners q(p);
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double a = angle(q.edge[i], -1 * q.edge[(i + 3) % 4]);
        most = std::max(most, q.jacobian[i] < 0 ? 360 - a : a);
    }
    return most;
}

} // namespace quad
} // namespace nmgs
