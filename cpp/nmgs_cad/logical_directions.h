// SPDX-License-Identifier: LGPL-2.1-or-later
// Which of the directions +-xi, +-eta, +-zeta the faces of a solid look in and its edges run along,
// when the solid is taken for one made of cubes (submapping: D. White, L. Mingwu, S. Benzley,
// G. Sjaardema, Automated hexahedral mesh generation by virtual decomposition, 4th IMR, 1995).
#pragma once

#include "nmgs_cad/solid_boundary.h"

#include <cstdint>
#include <vector>

namespace nmgs::cad {

// Directions: 0 +xi, 1 -xi, 2 +eta, 3 -eta, 4 +zeta, 5 -zeta.
struct LogicalDirections {
    std::vector<std::int8_t> face;   // of each face of the boundary, outward
    std::vector<std::int8_t> coedge; // of each coedge
    double cost;                     // how far the angles are from what they are taken for
};

constexpr int axis_of(int direction) {
    return direction / 2;
}
constexpr int sign_of(int direction) {
    return direction % 2 == 0 ? 1 : -1;
}

// How often `from` turns by a right angle about `axis` to become `to`: 0 to 3; -1 where it never
// does.
int quarter_turns(int axis, int from, int to);

// The cheapest assignments, best first, such that each angle of a face at a vertex and of the solid
// along an edge is a right angle, flat, or three right angles, and that each face closes. Empty,
// and the refusal, when there is none.
std::vector<LogicalDirections> logical_directions(const CadShape &shape,
                                                  const SolidBoundary &boundary, Refusal &refusal);

} // namespace nmgs::cad
