// SPDX-License-Identifier: LGPL-2.1-or-later
// The four hexahedra that a tetrahedron is split into, one a corner.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <cstddef>

namespace nmgs {

// For each corner the three others, right-handed: of the opposite face, seen from the corner.
constexpr std::array<std::array<std::size_t, 3>, 4> tet_others{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};
// Number of the edge between two corners.
constexpr std::array<std::array<std::size_t, 4>, 4> tet_edge_of{
    {{9, 0, 1, 2}, {0, 9, 3, 4}, {1, 3, 9, 5}, {2, 4, 5, 9}}};
constexpr std::array<std::array<std::size_t, 2>, 6> tet_edges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

// Least scaled Jacobian of the four hexahedra of a tetrahedron: corners, middles of the edges 01,
// 02, 03, 12, 13, 23, points on the faces opposite each corner. What is no better than `floor` is
// not measured to the end.
double hexas_quality(const std::array<Vec3, 4> &corners, const std::array<Vec3, 6> &middles,
                     const std::array<Vec3, 4> &centres, double floor = -2);

} // namespace nmgs
