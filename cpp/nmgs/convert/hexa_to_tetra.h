// SPDX-License-Identifier: LGPL-2.1-or-later
// Hexahedra into twelve tetrahedra each, by a node at the centroid (thesis 3.2.1).
#pragma once

#include "nmgs/convert/flip_diagonals.h"
#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

// hexahedra: M * 8 nodes in [0, points.size()); tetrahedra: M * 48; centroids: M.
// Hexahedron h becomes tetrahedra 12 h ... 12 h + 11, two a face, with the new node first_centroid
// + h at centroids[h] as their last node. Faces are split by their shorter diagonal, equal ones as
// diagonal.h says, so neighbours agree for every input. The new node is the mean of the eight
// corners; where that leaves a tetrahedron without positive volume (a strongly warped hexahedron),
// it is moved to a place inside that keeps all twelve positive. Where there is none, faces are
// split by their longer diagonal (see flip_diagonals.h); these faces are returned.
std::vector<FlippedFace> split_hexahedra(std::span<const Vec3> points,
                                         std::span<const std::int32_t> hexahedra,
                                         std::int32_t first_centroid,
                                         std::span<std::int32_t> tetrahedra,
                                         std::span<Vec3> centroids, const Progress &progress = {},
                                         double from = 0.0, double to = 1.0);

} // namespace nmgs
