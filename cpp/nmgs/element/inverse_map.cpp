// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/inverse_map.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <algorithm>
#include <cmath>

namespace nmgs {
namespace {

constexpr int most_steps = 30;
constexpr double settled = 1e-10;
constexpr double farthest = 1.5;

double clamped(double value, double limit) {
    return std::clamp(value, -limit, limit);
}

} // namespace

std::optional<std::array<double, 3>> find_natural(std::span<const Vec3, 20> nodes, Vec3 point) {
    std::array<double, 3> at{0, 0, 0};
    int far = 0;
    for (int step = 0; step < most_steps; ++step) {
        const auto n = hexa20::shape(at[0], at[1], at[2]);
        const auto d = hexa20::derivatives(at[0], at[1], at[2]);
        Vec3 r = point;
        Vec3 a{0, 0, 0};
        Vec3 b{0, 0, 0};
        Vec3 c{0, 0, 0};
        for (std::size_t i = 0; i < 20; ++i) {
            r += -n[i] * nodes[i];
            a += d.xi[i] * nodes[i];
            b += d.eta[i] * nodes[i];
            c += d.zeta[i] * nodes[i];
        }
        const double det = determinant(a, b, c);
        if (det == 0 || !std::isfinite(det)) {
            return std::nullopt;
        }
        const std::array<double, 3> change{determinant(r, b, c) / det, determinant(a, r, c) / det,
                                           determinant(a, b, r) / det};
        double largest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            // Far outside the mapping may fold: steps are short and stay near the element.
            at[k] = clamped(at[k] + clamped(change[k], 0.7), farthest);
            largest = std::max(largest, std::abs(change[k]));
        }
        // Twice at the border of what is looked at: the place is outside.
        if (std::any_of(at.begin(), at.end(), [](double t) { return std::abs(t) >= farthest; }) &&
            ++far == 2) {
            return std::nullopt;
        }
        if (largest < settled) {
            const bool inside =
                std::all_of(at.begin(), at.end(), [](double t) { return std::abs(t) <= 1 + 1e-6; });
            return inside ? std::optional(at) : std::nullopt;
        }
    }
    return std::nullopt;
}

Foot find_foot(std::span<const Vec3, 8> nodes, Vec3 point) {
    double xi = 0;
    double eta = 0;
    bool inside = false;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 r = point - quad8::map(nodes, xi, eta);
        const auto t = quad8::tangents(nodes, xi, eta);
        const double aa = norm2(t.xi);
        const double ab = dot(t.xi, t.eta);
        const double bb = norm2(t.eta);
        const double ra = dot(r, t.xi);
        const double rb = dot(r, t.eta);
        const double det = aa * bb - ab * ab;
        if (!(det > 1e-14 * aa * bb)) {
            break;
        }
        const double dx = clamped((ra * bb - rb * ab) / det, 0.7);
        const double de = clamped((rb * aa - ra * ab) / det, 0.7);
        const double new_xi = clamped(xi + dx, 1);
        const double new_eta = clamped(eta + de, 1);
        const double moved = std::max(std::abs(new_xi - xi), std::abs(new_eta - eta));
        inside = std::abs(dx) < 1e-6 && std::abs(de) < 1e-6;
        xi = new_xi;
        eta = new_eta;
        if (moved < settled) {
            break;
        }
    }
    return {xi, eta, distance(point, quad8::map(nodes, xi, eta)), inside};
}

} // namespace nmgs
