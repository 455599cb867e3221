// SPDX-License-Identifier: LGPL-2.1-or-later
// Which diagonal splits a quadrilateral: the shorter one (thesis 3.1.1, eq. 3.1).
#pragma once

#include "nmgs/support/vec3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nmgs {

// Squared lengths that differ by less than this share of their sum count as equal: what rounding
// leaves of the two diagonals of a square far from the origin.
constexpr double diagonal_tolerance = 1e-9;

// The thesis's triangulation parameter TP of a surface's quad: true joins nodes 2 and 4, which is
// so when d2 <= d1.
inline bool joins_second_and_fourth(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const double d1 = norm2(a - c);
    const double d2 = norm2(b - d);
    return d2 - d1 <= diagonal_tolerance * (d1 + d2);
}

// The same for a face of volume cells, given node numbers as well: of equal diagonals it takes the
// one that ends in the lowest node number. The answer is a property of the face: it does not depend
// on which cell asks, from which corner it starts, or in which sense it runs round, because
// |p - q|^2 and |q - p|^2 are the same to the bit.
inline bool joins_second_and_fourth(Vec3 a, Vec3 b, Vec3 c, Vec3 d, std::int32_t ia,
                                    std::int32_t ib, std::int32_t ic, std::int32_t id) {
    const double d1 = norm2(a - c);
    const double d2 = norm2(b - d);
    const double difference = d2 - d1;
    const bool equal = std::abs(difference) <= diagonal_tolerance * (d1 + d2);
    const bool lowest = std::min(ib, id) < std::min(ia, ic);
    return (equal & lowest) | (!equal & (difference < 0));
}

} // namespace nmgs
