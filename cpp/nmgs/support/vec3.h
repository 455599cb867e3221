// SPDX-License-Identifier: LGPL-2.1-or-later
// A point or vector of three doubles, laid out as a row of a float64 (N, 3) array.
#pragma once

#include <cmath>
#include <limits>

namespace nmgs {

struct Vec3 {
    double x, y, z;
};
static_assert(sizeof(Vec3) == 3 * sizeof(double));

constexpr Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator*(double s, Vec3 a) {
    return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec3 operator*(Vec3 a, double s) {
    return s * a;
}
constexpr Vec3 &operator+=(Vec3 &a, Vec3 b) {
    return a = a + b;
}
constexpr bool operator==(Vec3 a, Vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

constexpr double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double determinant(Vec3 a, Vec3 b, Vec3 c) {
    return dot(a, cross(b, c));
}
constexpr double norm2(Vec3 a) {
    return dot(a, a);
}
inline double norm(Vec3 a) {
    return std::sqrt(norm2(a));
}
inline double distance(Vec3 a, Vec3 b) {
    return norm(a - b);
}
// Of length 1; a vector of length 0 stays as it is.
inline Vec3 unit(Vec3 a) {
    const double length = norm(a);
    return length > 0 ? (1 / length) * a : a;
}
// In [0, pi], in radians.
inline double angle_between(Vec3 a, Vec3 b) {
    return std::atan2(norm(cross(a, b)), dot(a, b));
}
inline bool is_finite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// Axis-aligned box; empty until the first point is added.
struct Box {
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

    void add(Vec3 p) {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y,
                p.z > high.z ? p.z : high.z};
    }
    [[nodiscard]] double diagonal() const { return low.x > high.x ? 0.0 : distance(low, high); }
    // True when the boxes come within gap of each other.
    [[nodiscard]] bool near(const Box &other, double gap) const {
        return low.x <= other.high.x + gap && other.low.x <= high.x + gap &&
               low.y <= other.high.y + gap && other.low.y <= high.y + gap &&
               low.z <= other.high.z + gap && other.low.z <= high.z + gap;
    }
    [[nodiscard]] bool near(Vec3 p, double gap) const {
        return low.x <= p.x + gap && p.x <= high.x + gap && low.y <= p.y + gap &&
               p.y <= high.y + gap && low.z <= p.z + gap && p.z <= high.z + gap;
    }
};

} // namespace nmgs
