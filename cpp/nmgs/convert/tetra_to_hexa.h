// SPDX-License-Identifier: LGPL-2.1-or-later
// Tetrahedra into four hexahedra each (thesis 2.4.1): nodes in the middles of edges and faces and
// at the centroid. Conforming, and positive where the tetrahedra are.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

struct HexahedraOfTetrahedra {
    Array<std::int32_t> hexahedra; // tetrahedron t gives 4 t ... 4 t + 3, at its corners 0 ... 3
    // Corners of the nodes that are to be made: one a face from first_face on, in the order in
    // which the tetrahedra, then the triangles, name them; one a tetrahedron behind these.
    std::vector<std::array<std::int32_t, 3>> face_corners;
    std::vector<std::int32_t> face_of_triangle; // number of each triangle's face
};

// tetrahedra: M * 10 nodes (tetra10), the mid-sides in [corners, first_face); triangles: K * 3
// corners, faces of the tetrahedra or not.
// Raises ArgumentError when a node is not in [0, first_face), or there are too many new nodes.
HexahedraOfTetrahedra split_tetrahedra(std::int32_t first_face,
                                       std::span<const std::int32_t> tetrahedra,
                                       std::span<const std::int32_t> triangles,
                                       const Progress &progress = {});

} // namespace nmgs
