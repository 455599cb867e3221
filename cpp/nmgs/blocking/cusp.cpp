// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/cusp.h"

#include <cmath>
#include <cstddef>

namespace nmgs {

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

} // namespace nmgs
