// SPDX-License-Identifier: LGPL-2.1-or-later
// Every face of the volume cells of a mesh once.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

struct Face {
    std::array<std::int32_t, 4> key; // corners ascending; the last of a triangle is 2^31 - 1
    std::int32_t uses = 0;           // cells that have the face; 1 on the boundary
    std::uint8_t block = 0;          // where it was seen first: block of cells,
    std::uint8_t local = 0;          // face of the cell,
    std::int32_t cell = 0;           // cell of the block
};

struct Faces {
    std::vector<Face> faces; // in the order in which the cells first name them
    // Of each block of cells: face numbers of cell c from c * faces(type).size() on.
    std::vector<Array<std::int32_t>> of_cells;
};

// Linear in the number of cells, as find_edges.
// Raises ArgumentError when a cell's node is not in [0, points), or face numbers exceed 32 bits.
Faces find_faces(std::size_t points, std::span<const CellView> cells, const Progress &progress = {},
                 double from = 0.0, double to = 1.0);

} // namespace nmgs
