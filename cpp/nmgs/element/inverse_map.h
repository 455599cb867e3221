// SPDX-License-Identifier: LGPL-2.1-or-later
// Natural coordinates of a place in an element, by Newton's and Gauss-Newton's methods.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <optional>
#include <span>

namespace nmgs {

// (xi, eta, zeta) with |coordinate| <= 1 + 1e-6 of the point in a 20-node block, or nothing when it
// is outside or the iteration does not settle.
std::optional<std::array<double, 3>> find_natural(std::span<const Vec3, 20> nodes, Vec3 point);

// The foot of a point on an 8-node patch: nearest place near the middle's basin, kept inside.
struct Foot {
    double xi, eta;
    double distance;
    bool inside; // the foot is a perpendicular one, not one stopped at the rim
};
Foot find_foot(std::span<const Vec3, 8> nodes, Vec3 point);

} // namespace nmgs
