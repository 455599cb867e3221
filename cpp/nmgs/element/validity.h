// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether a curved element folds over itself anywhere, not only at its nodes. The Jacobian is a
// polynomial; its Bernstein coefficients bound it from both sides, and the element is halved until
// the bounds decide (Johnen, Remacle, Geuzaine, Geometrical validity of curvilinear finite
// elements, J. Comput. Phys. 233, 2013).
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <span>

namespace nmgs {

enum class Validity {
    valid,
    mirrored,  // the Jacobian is negative everywhere: valid once its numbering is turned round
    collapsed, // the Jacobian reaches zero, but not below
    folded     // the Jacobian changes its sign
};

struct ValidityResult {
    Validity validity;
    std::array<double, 3> natural; // where it is not valid; 0 for a valid or mirrored element
};

// A 20-node block; its Jacobian is of degree 5 in each direction.
// Zero means below 1e-9 of the largest coefficient.
ValidityResult check_validity(std::span<const Vec3, 20> nodes);

// An 8-node patch in space: its normal, the cross product of the tangents, of degree 3 in each
// direction, must not vanish. Where it does, the patch is folded, or collapsed when that is on a
// corner or edge whose normal just runs out. A patch alone is never mirrored.
ValidityResult check_validity(std::span<const Vec3, 8> nodes);

} // namespace nmgs
