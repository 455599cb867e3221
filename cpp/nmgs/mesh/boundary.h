// SPDX-License-Identifier: LGPL-2.1-or-later
// Outer faces of a volume mesh, or the free edges of a surface mesh.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace nmgs {

struct BoundaryBlock {
    CellType type;             // triangle, triangle6, quad, quad8; line, line3 of a surface mesh
    Array<std::int32_t> nodes; // the mesh's own node numbers, seen from outside
    std::vector<std::int32_t> blocks; // block and cell of the mesh that has the face
    std::vector<std::int32_t> cells;
};

// Faces that belong to one volume cell only; without volume cells, edges that belong to one surface
// cell only, in that cell's direction. Order: as the cells name them, triangles before quads.
// Raises ArgumentError when a cell's node is not in [0, points).
std::vector<BoundaryBlock> boundary(std::size_t points, std::span<const CellView> cells,
                                    const Progress &progress = {});

} // namespace nmgs
