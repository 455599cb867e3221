// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/cusp.h"

#include "nmgs/element/hexa20.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nmgs {
namespace {

constexpr double wanted = 0.203; // sine at a corner, of elements at a cusp

// A block's corner: the far end and the middle of the edge along each direction.
struct Corner {
    std::size_t at;
    std::array<std::size_t, 3> end, middle;
    std::array<std::size_t, 3> side; // 0 at -1, 1 at +1
    double sign;                     // of the directions into the block
};

std::array<Corner, 8> corners_of_block() {
    const auto node_at = [](std::array<double, 3> t) {
        const auto *found = std::find(hexa20::natural.begin(), hexa20::natural.end(), t);
        return static_cast<std::size_t>(found - hexa20::natural.begin());
    };
    std::array<Corner, 8> corners{};
    for (std::size_t c = 0; c < 8; ++c) {
        Corner &corner = corners[c];
        corner.at = c;
        corner.sign = 1;
        for (std::size_t d = 0; d < 3; ++d) {
            auto t = hexa20::natural[c];
            corner.side[d] = t[d] < 0 ? 0 : 1;
            corner.sign *= -t[d];
            t[d] = -t[d];
            corner.end[d] = node_at(t);
            t[d] = 0;
            corner.middle[d] = node_at(t);
        }
    }
    return corners;
}

const std::array<Corner, 8> &corners() {
    static const std::array<Corner, 8> all = corners_of_block();
    return all;
}

// Scaled Jacobian at a corner of the element that has these shares of the block's directions there.
double jacobian(const EdgePlace &edges, const Corner &corner, const std::array<double, 3> &share) {
    const Vec3 p = edges(corner.at, 0, 0);
    std::array<Vec3, 3> edge{};
    double sizes = 1;
    for (std::size_t d = 0; d < 3; ++d) {
        edge[d] = edges(corner.at, d, share[d]) - p;
        sizes *= norm(edge[d]);
    }
    return sizes > 0 ? corner.sign * determinant(edge[0], edge[1], edge[2]) / sizes : -1;
}

// The directions along which two divisions would spoil the corner.
std::array<bool, 3> spoilt_at(const EdgePlace &edges, const Corner &corner) {
    constexpr double sound = 0.15; // what a corner is at least that is worth keeping
    constexpr double worse = 0.85; // times what it is undivided
    std::array<bool, 3> result{};
    const double whole = jacobian(edges, corner, {1, 1, 1});
    for (std::size_t d = 0; d < 3 && whole >= sound; ++d) {
        std::array<double, 3> halved{1, 1, 1};
        halved[d] = 0.5;
        const double then = jacobian(edges, corner, halved);
        result[d] = then < 0.99 * wanted && then < worse * whole;
    }
    return result;
}

} // namespace

bool ends_in_cusp(std::span<const Vec3> nodes) {
    constexpr double sharp = 0.2;  // radians, of the tangents
    constexpr double narrow = 0.8; // of the chords
    constexpr double bent = 0.6;   // of the chords' angle, what the tangents' is at most
    for (std::size_t c = 0; c < 4; ++c) {
        const Vec3 p = nodes[c];
        const Vec3 ahead = nodes[(c + 1) % 4] - p;
        const Vec3 back = nodes[(c + 3) % 4] - p;
        const Vec3 normal = cross(ahead, back);
        const double chords = std::atan2(norm(normal), dot(ahead, back));
        if (!(norm(normal) > 0) || chords > narrow) {
            continue;
        }
        // Derivatives of the quadratics through the ends and the mid-side nodes.
        const Vec3 a = 4 * (nodes[4 + c] - p) - ahead;
        const Vec3 b = 4 * (nodes[4 + (c + 3) % 4] - p) - back;
        const double tangents = std::atan2(dot(cross(a, b), normal) / norm(normal), dot(a, b));
        // Where the sides themselves turn sharply the patch is too coarse to tell.
        const auto turn = [&](Vec3 start, Vec3 chord) {
            const Vec3 end = 2 * chord - start;
            return std::atan2(norm(cross(start, end)), dot(start, end));
        };
        constexpr double most_turn = 0.55;
        if (tangents < sharp && tangents < bent * chords && turn(a, ahead) < most_turn &&
            turn(b, back) < most_turn) {
            return true;
        }
    }
    return false;
}

EdgePlace edges_of(std::span<const Vec3, 20> nodes) {
    return [nodes](std::size_t c, std::size_t d, double f) {
        const Corner &corner = corners()[c];
        return (1 - f) * (1 - 2 * f) * nodes[c] + 4 * f * (1 - f) * nodes[corner.middle[d]] +
               f * (2 * f - 1) * nodes[corner.end[d]];
    };
}

std::array<bool, 3> spoilt_by_division(std::span<const Vec3, 20> nodes) {
    std::array<bool, 3> result{};
    const EdgePlace edges = edges_of(nodes);
    for (const Corner &corner : corners()) {
        const auto spoilt = spoilt_at(edges, corner);
        for (std::size_t d = 0; d < 3; ++d) {
            result[d] = result[d] || spoilt[d];
        }
    }
    return result;
}

bool ends_in_knife(std::span<const Vec3, 20> nodes) {
    constexpr double near = 0.02;  // of an edge, for its tangent
    constexpr double sharp = 0.94; // cosine of the angle between tangents
    const EdgePlace edges = edges_of(nodes);
    return std::any_of(corners().begin(), corners().end(), [&](const Corner &corner) {
        const auto spoilt = spoilt_at(edges, corner);
        if (std::none_of(spoilt.begin(), spoilt.end(), [](bool s) { return s; })) {
            return false;
        }
        const auto along = [&](std::size_t d) {
            return unit(edges(corner.at, d % 3, near) - nodes[corner.at]);
        };
        return dot(along(0), along(1)) > sharp || dot(along(1), along(2)) > sharp ||
               dot(along(2), along(0)) > sharp;
    });
}

std::array<std::array<double, 2>, 3> shares_of_ends(std::span<const Vec3, 20> nodes,
                                                    const EdgePlace &edges,
                                                    const std::array<std::int32_t, 3> &divisions) {
    constexpr double step = 0.02;
    constexpr double gain = 1.3; // what it must be better by where it cannot be as wanted
    constexpr double kept = 0.995;
    constexpr double doubtful = 0.35;
    std::array<std::array<double, 2>, 3> result{};
    const std::array<double, 3> even{1.0 / divisions[0], 1.0 / divisions[1], 1.0 / divisions[2]};
    for (const Corner &corner : corners()) {
        // The quadratic's tangents are a little off.
        if (jacobian(edges_of(nodes), corner, even) > doubtful) {
            continue;
        }
        const double now = jacobian(edges, corner, even);
        if (now >= kept * wanted) {
            continue;
        }
        std::array<double, 3> best = even;
        double found = now;
        for (double share = step; share < 1 + 0.5 * step && found < wanted; share += step) {
            std::array<double, 3> f = even;
            for (double &value : f) {
                value = std::max(value, std::min(share, 1.0));
            }
            const double then = jacobian(edges, corner, f);
            if (then > found) {
                found = then;
                best = f;
            }
        }
        if (found < gain * std::max(now, 0.0) || found < 0.25 * wanted) {
            continue;
        }
        // Only along the directions on which it depends.
        const double enough = kept * std::min(found, wanted);
        for (std::size_t d = 0; d < 3; ++d) {
            auto f = best;
            f[d] = even[d];
            if (jacobian(edges, corner, f) >= enough) {
                best = f;
            }
        }
        for (std::size_t d = 0; d < 3; ++d) {
            if (best[d] > even[d]) {
                double &share = result[d][corner.side[d]];
                share = std::max(share, best[d]);
            }
        }
    }
    return result;
}

} // namespace nmgs
